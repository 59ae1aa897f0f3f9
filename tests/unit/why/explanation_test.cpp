// Explanations as lines and as JSON, and the names of what can be explained.
#include <nlohmann/json.hpp>

#include "why_support.hpp"

namespace symplant::test {
namespace {

const why::Explanation kExample{
    "a", {{why::Reference::Kind::unit, 0}}, {{"b", {{why::Reference::Kind::symbol, 3}}, {{"c"}}}, {"d"}}};

TEST_CASE("Lines are indented by their level") {
  CHECK(why::lines_of(kExample) == std::vector<std::string>{"a", "    b", "        c", "    d"});
  CHECK(why::in_one_line(kExample) == "a; b; c; d");
}

TEST_CASE("JSON has the names of what a sentence is about") {
  const DescribedPlant cell(with_prefix(kCell), "\"name\": \"x\"");
  const trace::PlantNames names(cell.rows);
  const auto json = nlohmann::json::parse(why::json_of(kExample, names));
  CHECK(json == nlohmann::json::parse(R"({"sentence":"a","about":[{"device":"L_P_AGV"}],"because":[
      {"sentence":"b","about":[{"symbol":"L_P_AGV_O_P2"}],"because":[{"sentence":"c","about":[],"because":[]}]},
      {"sentence":"d","about":[],"because":[]}]})"));
}

TEST_CASE("Everything with a name is found, without regard to case") {
  const DescribedPlant plant(with_prefix(kCell), R"(
      "material": {"kinds": {"raw": {"length": "1 m"}}, "tracks": {}, "places": {"BIN": {}},
        "sources": [{"name": "infeed", "at": "BIN", "kind": "raw"}]},
      "requirements": [{"name": "apart", "never": "L_P_AGV.P2"}])");
  const trace::PlantNames names(plant.rows);
  const auto kind_of = [&](const std::string& name) {
    const auto things = why::things_named(name, names);
    REQUIRE(things.size() == 1);
    return things.front().kind;
  };
  using Kind = why::Reference::Kind;
  CHECK(kind_of("l_p_agv") == Kind::unit);
  CHECK(kind_of("L_P_AGV_I_p2") == Kind::symbol);
  CHECK(kind_of("APART") == Kind::requirement);
  CHECK(kind_of("bin") == Kind::location);
  CHECK(kind_of("infeed") == Kind::source);
  tables::PlantTables facets = plant.rows;
  const std::string unit_names{"L_P_A.X\0L_P_A.Y\0L_P_AB.X\0", 25};
  const std::vector<tables::UnitRow> units(3);
  facets.unit_names = unit_names;
  facets.units = units;
  CHECK(why::things_named("l_p_a", trace::PlantNames(facets)).size() == 2);
  CHECK(why::things_named("L_P", names).empty());
  CHECK(why::nearest_thing("L_P_AGW", names) == "L_P_AGV");
  CHECK(why::nearest_thing("inpheed", names) == "infeed");
  CHECK(why::nearest_thing("something else", names).empty());
}

}  // namespace
}  // namespace symplant::test
