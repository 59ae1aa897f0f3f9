// What Plant shows of times that run, and of parts, transfers and sources.
#include "support/described_plant.hpp"
#include "support/plant_bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The time that a cause must still hold is shown, also while its unit is disabled") {
  Reported reported;
  reported.by_itself("MC", "RUN2", "IDLE1", fixed(500 * kMs)).disables("DOOR", "OPEN2", "MC");
  const BenchTables tables({"MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2", "DOOR_I_SHUT1", "DOOR_I_OPEN2"}, reported);
  BenchPlant plant(tables);
  const std::uint32_t mc = tables.unit_index("MC");
  plant.set("MC_O_RUN2", 1).to(0);
  CHECK(plant.plant.after_left(mc, 0) == tables::kNever);  // it moves
  plant.to(1000).to(1200);
  REQUIRE(plant.state("MC") == "RUN2");
  CHECK(plant.plant.after_left(mc, 0) == 300 * kMs);
  CHECK(plant.plant.after_left(mc, 1) == tables::kNever);  // commanded, at once
  plant.put("DOOR", "OPEN2").to(1200).to(1300);
  CHECK(plant.plant.after_left(mc, 0) == 300 * kMs);
  CHECK(plant.plant.after_left(tables.unit_index("DOOR"), 0) == tables::kNever);
}

TEST_CASE("A part's speed, a spent transfer and a source's next part are shown") {
  const DescribedPlant tables(bits({"L_P_BELT_O_RUN", "L_P_BELT_I_RUN", "L_P_ARM_O_PICK", "L_P_ARM_I_PICK"}), R"(
    "material": {
      "kinds": {"box": {"length": "200 mm"}},
      "tracks": {"CV": {"length": "2 m", "drives": [{"forward": "L_P_BELT_O_RUN", "speed": "0.5 m/s"}]}},
      "places": {"BIN": {"holds": 3}},
      "transfers": [{"name": "pick", "from": "CV", "to": "BIN", "when": "L_P_ARM_O_PICK", "once": true}],
      "sources": [{"name": "infeed", "at": "CV", "kind": "box", "every": "3s", "count": 2}]})");
  plant::OwnedPlant plant(tables.rows);
  plant.advance_to(0);
  CHECK(plant.part(0, 0).speed == 0);
  CHECK(plant.source(0).made == 1);
  CHECK(plant.source(0).due == 3 * tables::kSecond);
  CHECK(plant.transfer(0).spent);
  plant.set_operation(tables.rows.symbols[tables.symbol("L_P_BELT_O_RUN")].index, true);
  plant.set_operation(tables.rows.symbols[tables.symbol("L_P_ARM_O_PICK")].index, true);
  plant.advance_to(tables::kSecond);
  CHECK(plant.part(0, 0).speed == 500'000);
  CHECK(plant.part(0, 0).drive == 0);
  CHECK_FALSE(plant.transfer(0).spent);
  plant.advance_to(5 * tables::kSecond);
  CHECK(plant.source(0).due == tables::kNever);
  CHECK(plant.transfer(0).spent);
  CHECK(plant.parts(tables.location("BIN")) == 1);
}

}  // namespace
}  // namespace symplant::test
