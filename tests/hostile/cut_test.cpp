// A small list and a small plant.json, cut at every byte, in process.
#include <algorithm>
#include <string>
#include <vector>

#include "inputs.hpp"
#include "support/catch.hpp"
#include "support/tool.hpp"

namespace symplant::hostile {
namespace {

constexpr const char* kDescription = R"({ "symplant": 1, "symbols": ["symbols.csv"], // ein Gru)"
                                     "\xC3\x9F"
                                     R"(
  "devices": { "L_P_AGV": { "transitions": [ { "from": "P1", "to": "P2", "takes": "2s", "when": "not L_P_CYL.ADV" } ] } },
  "requirements": [ { "name": "r\u00e4", "never": "L_P_AGV.P1 and LEVEL > 1e3" } ] }
)";

/// Checks and generates from every prefix of a file; counts each exit code.
std::vector<int> cut(const std::string& name, const std::string& content) {
  std::vector<int> codes(3);
  for (std::size_t size = 0; size <= content.size(); ++size) {
    test::MemoryFileSystem files;
    files.files["symbols.csv"] = good_list();
    files.files[name] = content.substr(0, size);
    INFO(name << " cut at byte " << size);
    const test::ToolRun checked = test::run_tool({"check", name}, files);
    REQUIRE((checked.code >= 0 && checked.code <= 2));
    ++codes[static_cast<std::size_t>(checked.code)];
    if (checked.code == 2) REQUIRE(checked.out.find(name) != std::string::npos);
    const test::ToolRun generated = test::run_tool({"generate", name, "-o", "out"}, files);
    REQUIRE((generated.code == 0 || generated.code == 2));
    REQUIRE(files.written.empty() == (generated.code == 2));
    REQUIRE((checked.code == 0) == (generated.code == 0));
  }
  return codes;
}

TEST_CASE("A list cut anywhere is read to the cut or rejected, a rejected list leaves no output") {
  const std::vector<int> codes = cut("symbols.csv", good_list());
  CHECK(codes[0] > 100);
  CHECK(codes[2] > 10);
}

TEST_CASE("A quoted list of several scripts, cut anywhere, is read or rejected without output") {
  std::string text = "\xEF\xBB\xBF";
  text += kHeader;
  for (const std::string& name : hostile_names()) {
    if (name.size() < 20)
      text += "VAR_GLOBAL,\"" + std::string(name.find('"') == name.npos ? name : "\"\"") + "\",,,BOOL,\r\n";
  }
  CHECK(cut("symbols.csv", text)[2] > 100);
}

TEST_CASE("A plant.json cut anywhere is rejected, a whole one is accepted") {
  const std::string text = kDescription;
  const std::vector<int> codes = cut("plant.json", text);
  CHECK(codes[0] == 2);  // with and without the last line end
  CHECK(codes[1] == 0);
}

}  // namespace
}  // namespace symplant::hostile
