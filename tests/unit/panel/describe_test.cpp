// What the description of a plant has from the view: comments of symbols, and what a person operates.
#include "symplant/panel/picture/describe.hpp"

#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

Json described(const BenchTables& tables, const panel::View& view) {
  const trace::PlantNames names(tables.rows);
  std::string json = "{";
  panel::put_plant(json, names, view, {}, panel::Role::trainer);
  return Json::parse(json + "}");
}

TEST_CASE("A symbol of the description has its comment, and whether a person operates it, only if it is so") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "START_I_PUSH"});
  std::vector<panel::SymbolView> symbols(tables.rows.symbols.size());
  symbols[tables.symbol("AGV_I_P2")].comment = "vehicle at \"2\"\n<b>전진</b>";
  symbols[tables.symbol("START_I_PUSH")] = {.comment = "", .by_operator = true};
  const Json plant = described(tables, {.symbols = symbols});
  CHECK(plant.at("symbols").at(tables.symbol("AGV_I_P2")).at("comment") == "vehicle at \"2\"\n<b>전진</b>");
  CHECK_FALSE(plant.at("symbols").at(tables.symbol("AGV_I_P2")).contains("operator"));
  CHECK_FALSE(plant.at("symbols").at(tables.symbol("AGV_I_P1")).contains("comment"));
  CHECK(plant.at("symbols").at(tables.symbol("START_I_PUSH")).at("operator") == true);
  CHECK_FALSE(plant.at("symbols").at(tables.symbol("START_I_PUSH")).contains("comment"));
}

TEST_CASE("Without a view no symbol of the description has a comment") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2"});
  const Json plant = described(tables, {});
  REQUIRE(plant.at("symbols").size() == 2);
  for (const Json& symbol : plant.at("symbols")) {
    CHECK_FALSE(symbol.contains("comment"));
    CHECK_FALSE(symbol.contains("operator"));
  }
}

TEST_CASE("A device of the description has its shape, and `view3d` is as plant.json gives it") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "START_I_PUSH"});
  CHECK(described(tables, {}).at("devices").at(0).at("shape") == "device");
  CHECK_FALSE(described(tables, {}).contains("view3d"));
  const std::vector<tables::Shape> shapes{tables::Shape::vehicle, tables::Shape::button};
  const Json plant = described(tables, {.shapes = shapes, .view3d = R"({"model":"cell.glb"})"});
  CHECK(plant.at("devices").at(0).at("shape") == "vehicle");
  CHECK(plant.at("devices").at(1).at("shape") == "button");
  CHECK(plant.at("view3d") == Json::parse(R"({"model":"cell.glb"})"));
}

}  // namespace
}  // namespace symplant::test
