// Malfunctions in the views of a model.
#include <nlohmann/json.hpp>

#include "support/malfunction_bench.hpp"
#include "symplant/json/schema.hpp"
#include "view_support.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

/// Each kind of malfunction, and one with a name that would end a script.
CompiledText faulty_plant() {
  std::vector<Row> rows = bits({"L_P_AGV_I_P1", "L_P_AGV_I_P2", "L_P_AGV_O_P2", "L_P_CYL_I_ADV", "L_P_PE_I_PART"});
  rows.push_back({"LEVEL", "", "INT", "5", "%IW30"});
  const Reported reported = with_malfunctions(R"(
    {"name":"slow","of":"*","slower":2.5,"when":"LEVEL > 3","becomes":{"after":"20s","unless":"L_P_PE_I_PART","start":"jam"}},
    {"name":"jam","of":"L_P_AGV","stuck":true,"lasts":"1s"},
    {"name":"thrown","of":["L_P_AGV"],"stuck":"p2","chance":{"mean":"10min","sigma":"2min"}},
    {"name":"blind","force":{"L_P_PE_I_PART":false,"LEVEL":-3}},
    {"name":"loose","flicker":{"symbol":"L_P_PE_I_PART","every":{"min":"1s","max":"5s"},"for":"80ms"}},
    {"name":"</script>","lose":true})");
  CompiledText made = compile_described(rows, reported.description);
  REQUIRE(made.compiled);
  return made;
}

TEST_CASE("The JSON form has the malfunctions with resolved names and in nanoseconds, and fits its schema") {
  const json data = json::parse(render(faulty_plant(), "json").text);
  const symplant::json::Schema checker(
      read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/generator/view/model.schema.json"));
  CHECK(checker.check(data).empty());
  CHECK(data.at("malfunctions") == json::parse(R"([
    {"name":"slow","of":["L_P_AGV","L_P_CYL","L_P_PE"],"slower":2.5,"when":"LEVEL > 3",
     "becomes":{"after":20000000000,"unless":"L_P_PE_I_PART","start":"jam"}},
    {"name":"jam","of":["L_P_AGV"],"stuck":true,"lasts":1000000000},
    {"name":"thrown","of":["L_P_AGV"],"stuck":"P2","chance":{"mean":600000000000,"sigma":120000000000}},
    {"name":"blind","force":{"L_P_PE_I_PART":false,"LEVEL":-3}},
    {"name":"loose","flicker":{"symbol":"L_P_PE_I_PART","every":{"min":1000000000,"max":5000000000},"for":80000000}},
    {"name":"</script>","lose":true}])"));
  CHECK_FALSE(json::parse(render(described_cell(), "json").text).contains("malfunctions"));
}

TEST_CASE("The table has a line for each malfunction") {
  CHECK(contains(render(faulty_plant(), "table").text, R"(
malfunctions
  slow: slower 2.5: L_P_AGV, L_P_CYL, L_P_PE; when LEVEL > 3; becomes `jam` after 20 s unless L_P_PE_I_PART
  jam: stuck: L_P_AGV; lasts 1 s
  thrown: stuck in P2: L_P_AGV; by chance, 600 s (sigma 120 s)
  blind: force L_P_PE_I_PART = FALSE, LEVEL = -3
  loose: flicker L_P_PE_I_PART for 80 ms every 1 s to 5 s
  </script>: lose the controller
)"));
  CHECK_FALSE(contains(render(described_cell(), "table").text, "malfunctions"));
}

TEST_CASE("The page has the malfunctions, and no name of one ends its script") {
  const std::string page = render(faulty_plant(), "html").text;
  CHECK(contains(page, R"(["jam","stuck: L_P_AGV; lasts 1 s"])"));
  std::size_t scripts = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++scripts;
  CHECK(scripts == 2);
}

}  // namespace
}  // namespace symplant::test
