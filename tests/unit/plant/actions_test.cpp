// External actions on a plant besides the PLC: forces, sources of inputs, manual moves; and actions before an instant.
#include "support/plant_bench.hpp"

namespace symplant::test {
namespace {

/// An AGV, buttons that no unit drives, numbers, and further names on some of the addresses.
const BenchTables& hall() {
  static const auto rows = [] {
    std::vector<Row> list = bits({"L_P_AGV_O_P1", "L_P_AGV_I_P1", "L_P_AGV_O_P2", "L_P_AGV_I_P2"});
    const std::vector<Row> more = {
        {"START", "", "BOOL", "FALSE", "%IX100"}, {"LEFT", "", "BOOL", "FALSE", "%IX101"},
        {"RIGHT", "", "BOOL", "FALSE", "%IX101"}, {"P2_LAMP", "", "BOOL", "FALSE", "%QX2"},
        {"P2_SEEN", "", "BOOL", "FALSE", "%IX3"}, {"LEVEL", "", "INT", "5", "%IW10"},
        {"SPEED", "", "INT", "7", "%QW10"},       {"SPEED_TOO", "", "INT", "7", "%QW10"},
    };
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  static const BenchTables tables({}, rows);
  return tables;
}

TEST_CASE("A forced operation is on for the plant, and shows its written value once released") {
  BenchPlant plant(hall());
  plant.to(0).force("AGV_O_P2", 1).to(100);
  CHECK(plant.on("AGV_O_P2"));
  CHECK(plant.forced("AGV_O_P2"));
  CHECK(plant.state("AGV") == "P1->P2");
  plant.release("AGV_O_P2").to(200);
  CHECK_FALSE(plant.on("AGV_O_P2"));
  CHECK_FALSE(plant.forced("AGV_O_P2"));
}

TEST_CASE("A value that the PLC writes under a force shows on release") {
  BenchPlant plant(hall());
  plant.to(0).force("AGV_O_P2", 0).set("AGV_O_P2", 1).to(100);
  CHECK_FALSE(plant.on("AGV_O_P2"));
  CHECK(plant.state("AGV") == "P1");
  plant.release("AGV_O_P2").to(200);
  CHECK(plant.on("AGV_O_P2"));
  CHECK(plant.state("AGV") == "P1->P2");
}

TEST_CASE("A unit's value for a forced event shows on release") {
  BenchPlant plant(hall());
  plant.to(0).force("AGV_I_P1", 1).force("AGV_I_P2", 0).set("AGV_O_P2", 1).to(0).to(2000);
  CHECK(plant.state("AGV") == "P2");
  CHECK(plant.on("AGV_I_P1"));
  CHECK_FALSE(plant.on("AGV_I_P2"));
  plant.changes();
  plant.release("AGV_I_P1").release("AGV_I_P2").to(2000);
  CHECK(plant.changes() == "2000:AGV_I_P1=0 2000:AGV_I_P2=1 2000:P2_SEEN=1");
}

TEST_CASE("Numbers are forced and released like bits") {
  BenchPlant plant(hall());
  plant.to(0);
  CHECK(plant.value("SPEED") == 7);
  plant.force("SPEED", 99).set("SPEED", 3).to(1);
  CHECK(plant.value("SPEED") == 99);
  plant.release("SPEED").to(2);
  CHECK(plant.value("SPEED") == 3);
  plant.force("LEVEL", 8);
  CHECK(plant.input("LEVEL", 6));
  plant.to(3);
  CHECK(plant.value("LEVEL") == 8);
  plant.release("LEVEL").to(4);
  CHECK(plant.value("LEVEL") == 6);
}

TEST_CASE("A force holds every symbol on the address until one of them is released") {
  BenchPlant plant(hall());
  plant.to(0).force("P2_LAMP", 1).force("P2_SEEN", 1).force("LEFT", 1).force("SPEED_TOO", 50).to(1);
  CHECK(plant.forced("AGV_O_P2"));
  CHECK(plant.state("AGV") == "P1->P2");
  CHECK(plant.on("AGV_I_P2"));
  CHECK(plant.on("RIGHT"));
  CHECK(plant.value("SPEED") == 50);
  plant.release("AGV_O_P2").release("AGV_I_P2").release("RIGHT").release("SPEED").to(2);
  CHECK_FALSE(plant.forced("P2_LAMP"));
  CHECK_FALSE(plant.on("P2_LAMP"));
  CHECK_FALSE(plant.on("P2_SEEN"));
  CHECK_FALSE(plant.on("LEFT"));
  CHECK(plant.value("SPEED_TOO") == 7);
}

TEST_CASE("A force may be set again with another value, and releasing an unforced symbol has no effect") {
  BenchPlant plant(hall());
  plant.to(0).force("START", 1).force("START", 0).to(1);
  CHECK_FALSE(plant.on("START"));
  CHECK(plant.forced("START"));
  plant.release("LEFT").release("START").release("START").to(2);
  CHECK_FALSE(plant.forced("START"));
  CHECK_FALSE(plant.on("START"));
}

TEST_CASE("A reset releases every force") {
  BenchPlant plant(hall());
  plant.to(0).force("AGV_O_P2", 1).force("LEVEL", 9).force("SPEED", 9).to(1);
  plant.plant.reset();
  plant.to(5000);
  CHECK(plant.state("AGV") == "P1");
  CHECK_FALSE(plant.forced("P2_LAMP"));
  CHECK(plant.value("LEVEL") == 5);
  CHECK(plant.value("SPEED") == 7);
}

TEST_CASE("The mask of a written word selects its operations, including their other names") {
  BenchPlant plant(hall());
  const std::uint32_t p1 = hall().rows.symbols[hall().symbol("AGV_O_P1")].index;
  const std::uint32_t p2 = hall().rows.symbols[hall().symbol("AGV_O_P2")].index;
  REQUIRE(p1 / 64 == p2 / 64);
  plant.to(0).set("AGV_O_P1", 1).to(0);
  plant.plant.set_operations(p2 / 64, std::uint64_t{1} << (p2 % 64), ~(std::uint64_t{1} << (p1 % 64)));
  plant.to(1);
  CHECK(plant.on("AGV_O_P1"));
  CHECK(plant.on("AGV_O_P2"));
  CHECK(plant.on("P2_LAMP"));
  plant.plant.set_operations(p2 / 64, ~std::uint64_t{0}, 0);
  plant.to(2);
  CHECK_FALSE(plant.on("AGV_O_P1"));
  CHECK_FALSE(plant.on("P2_LAMP"));
}

TEST_CASE("An input is set by its source, with all names of its address") {
  BenchPlant plant(hall());
  plant.to(0);
  CHECK(plant.input("START", 1));
  CHECK(plant.input("RIGHT", 1));
  CHECK(plant.input("LEVEL", 42));
  CHECK_FALSE(plant.on("START"));  // visible from the next instant on
  plant.changes();
  plant.to(1);
  CHECK(plant.changes() == "0:START=1 0:LEFT=1 0:RIGHT=1");
  CHECK(plant.value("LEVEL") == 42);
}

TEST_CASE("An operation, an event that a unit drives, and its followers cannot be set as inputs") {
  BenchPlant plant(hall());
  plant.to(0);
  const std::uint64_t hash = plant.plant.state_hash();
  CHECK_FALSE(plant.input("AGV_O_P2", 1));
  CHECK_FALSE(plant.input("P2_LAMP", 1));
  CHECK_FALSE(plant.input("SPEED", 1));
  CHECK_FALSE(plant.input("AGV_I_P2", 1));
  CHECK_FALSE(plant.input("P2_SEEN", 1));
  CHECK(plant.plant.state_hash() == hash);
  CHECK(plant.plant.next_due() == tables::kNever);
}

TEST_CASE("A manual move puts a settled unit into another state: it leaves the old one and enters the new one") {
  BenchPlant plant(hall());
  plant.to(0).changes();
  plant.put("AGV", "P2").to(100);
  CHECK(plant.state("AGV") == "P2");
  CHECK(plant.changes() == "0:AGV_I_P1=0 0:AGV_I_P2=1 0:P2_SEEN=1");
}

TEST_CASE("A manual move ends the current move") {
  BenchPlant plant(hall());
  plant.to(0).set("AGV_O_P2", 1).to(0).set("AGV_O_P2", 0).to(400);
  CHECK(plant.unit("AGV").remaining == 600 * kMs);
  plant.put("AGV", "P1").to(400);
  CHECK(plant.state("AGV") == "P1");
  CHECK(plant.unit("AGV").remaining == 0);
  CHECK(plant.unit("AGV").progress == 0.0);
  CHECK(plant.on("AGV_I_P1"));
  CHECK(plant.plant.next_due() == tables::kNever);
}

TEST_CASE("Levels count also after a manual move") {
  BenchPlant plant(hall());
  plant.to(0).set("AGV_O_P2", 1).to(0).to(1000);
  plant.put("AGV", "P1").to(1500);
  CHECK(plant.state("AGV") == "P1->P2");  // the command is still on
  CHECK(plant.unit("AGV").remaining == 500 * kMs);
}

TEST_CASE("A unit put into its current state starts to wait again") {
  const BenchTables tables({"MC_I_A1", "MC_I_B2"}, Reported().by_itself("MC", "A1", "B2", fixed(1000 * kMs)));
  BenchPlant plant(tables);
  plant.to(600).changes();
  plant.put("MC", "A1").to(1599);
  CHECK(plant.changes() == "");
  CHECK(plant.state("MC") == "A1");
  plant.to(1600);
  CHECK(plant.state("MC") == "B2");
}

TEST_CASE("A disabled unit stays disabled after a manual move") {
  const BenchTables tables(
      {"GATE_O_OPEN1", "GATE_I_OPEN1", "GATE_O_SHUT2", "GATE_I_SHUT2", "ARM_O_A1", "ARM_I_A1", "ARM_O_B2", "ARM_I_B2"},
      Reported().disables("GATE", "OPEN1", "ARM"));
  BenchPlant plant(tables);
  plant.to(0).set("ARM_O_A1", 1).put("ARM", "B2").to(1000);
  CHECK(plant.state("ARM") == "[B2]");
  CHECK(plant.on("ARM_I_B2"));
  plant.put("GATE", "SHUT2").to(1000);
  CHECK(plant.state("ARM") == "B2->A1");  // the new state counts at once, and so does the command
}

TEST_CASE("Before an instant nothing has changed, actions at that time belong to that instant") {
  BenchPlant plant(hall());
  plant.to(0).set("AGV_O_P2", 1).to(0).set("AGV_O_P2", 0).to(1).changes();
  plant.before(1000);
  CHECK(plant.plant.now() == 1000 * kMs);
  CHECK(plant.state("AGV") == "P1->P2");
  CHECK(plant.unit("AGV").remaining == 0);
  CHECK(plant.unit("AGV").progress == 1.0);
  CHECK(plant.plant.next_due() == 1000 * kMs);
  plant.input("START", 1);
  plant.force("LEFT", 1).to(1000);
  CHECK(plant.changes() == "1000:AGV_I_P2=1 1000:START=1 1000:LEFT=1 1000:RIGHT=1 1000:P2_SEEN=1");
}

TEST_CASE("An action after an instant runs another one at the same time, before later ones") {
  BenchPlant plant(hall());
  plant.to(100).changes();
  plant.force("AGV_O_P2", 1);
  CHECK(plant.plant.next_due() == 100 * kMs);
  plant.to(2000);
  CHECK(plant.changes() == "100:AGV_I_P1=0 100:AGV_O_P2=1 100:P2_LAMP=1 1100:AGV_I_P2=1 1100:P2_SEEN=1");
}

TEST_CASE("A written value is sampled by the instant of the next call, not by those before it") {
  BenchPlant plant(hall());
  plant.to(0).set("AGV_O_P2", 1).to(0).set("AGV_O_P2", 0).set("AGV_O_P1", 1).changes();
  plant.before(1500);
  CHECK(plant.changes() == "1000:AGV_I_P2=1 1000:P2_SEEN=1");
  CHECK(plant.on("AGV_O_P2"));
  plant.to(1500);
  CHECK(plant.changes() == "1500:AGV_O_P1=1 1500:AGV_O_P2=0 1500:AGV_I_P2=0 1500:P2_LAMP=0 1500:P2_SEEN=0");
}

TEST_CASE("A time that is reached already has no effect") {
  BenchPlant plant(hall());
  plant.to(100).force("START", 1).before(100);
  CHECK_FALSE(plant.on("START"));
  plant.before(50);
  CHECK(plant.plant.now() == 100 * kMs);
}

TEST_CASE("Changed values are reported once to the links, and all of them after a restore") {
  BenchPlant plant(hall());
  plant.to(0);
  plant.plant.forget_changed_events();
  plant.to(1);
  CHECK(plant.plant.changed_event_values().empty());
  plant.input("LEVEL", 6);
  plant.to(2);
  plant.input("LEVEL", 7);
  plant.to(3);
  CHECK(plant.plant.changed_event_values().size() == 1);
  const auto block = plant.plant.save();
  const std::vector<std::byte> kept(block.begin(), block.end());
  plant.plant.forget_changed_events();
  REQUIRE(plant.plant.restore(kept));
  CHECK(plant.plant.changed_event_values().size() == hall().rows.event_slots);
  CHECK(plant.plant.changed_events().size() == hall().rows.event_bits / 64);
}

TEST_CASE("Progress is the completed part of the travel") {
  BenchPlant plant(hall());
  plant.to(0).set("AGV_O_P2", 1).to(0);
  CHECK(plant.unit("AGV").progress == 0.0);
  plant.to(250);
  CHECK(plant.unit("AGV").progress == 0.25);
  plant.to(1000);
  CHECK(plant.unit("AGV").progress == 0.0);
}

TEST_CASE("An operation that a machine has used up is listed as disarmed until it has been off") {
  const BenchTables tables({"MC_I_IDLE1", "MC_O_RUN2", "MC_I_RUN2"});
  BenchPlant plant(tables);
  plant.to(0).set("MC_O_RUN2", 1).to(0).to(1000);
  CHECK(plant.state("MC") == "RUN2");
  CHECK_FALSE(plant.disarmed("MC_O_RUN2"));
  plant.to(2000);
  CHECK(plant.state("MC") == "IDLE1");
  CHECK(plant.disarmed("MC_O_RUN2"));
  plant.set("MC_O_RUN2", 0).to(2001);
  CHECK_FALSE(plant.disarmed("MC_O_RUN2"));
}

}  // namespace
}  // namespace symplant::test
