// A plant that shows its initial events before its first instant.
#include "support/plant_bench.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kRam = {"RAM_O_ADV", "RAM_I_ADV", "RAM_I_RET"};

TEST_CASE("A plant shows its initial events without a step, once, and then starts as ever") {
  Reported reported;
  description::DeviceDescription ram;
  ram.path = "L_P_RAM";
  ram.initial = "ADV";  // not its rest position: the first instant moves it
  reported.description.devices = {ram};
  const BenchTables tables(kRam, reported);
  BenchPlant plant(tables);
  plant.plant.show();
  CHECK(plant.plant.event(tables.rows.symbols[1].index));
  CHECK(plant.state("RAM") == "ADV");
  plant.plant.show();
  plant.to(0);
  CHECK(plant.state("RAM") == "ADV->RET");
  BenchPlant other(tables);
  other.to(0);
  CHECK(plant.plant.state_hash() == other.plant.state_hash());
}

}  // namespace
}  // namespace symplant::test
