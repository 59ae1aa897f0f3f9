// Malfunctions: what each kind does.
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

/// A vehicle; a sensor and a button that no unit drives.
const std::vector<std::string> kHall = {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1", "PE_I_PART", "BTN_I_RESET"};

TEST_CASE("A slower device needs more time for moves that begin, not for one in progress") {
  const FaultyTables tables(kHall, R"({"name":"slow","of":"L_P_AGV","slower":3})");
  BenchPlant plant(tables);
  plant.to(0).set("AGV_O_P2", 1).to(100);
  plant.start("slow").to(2000);
  CHECK(plant.changes() == "0:AGV_I_P1=1 100:AGV_I_P1=0 100:AGV_O_P2=1 1100:AGV_I_P2=1");
  plant.set("AGV_O_P2", 0).set("AGV_O_P1", 1).to(3000);
  plant.stop("slow").to(9000);
  CHECK(plant.changes() == "3000:AGV_I_P2=0 3000:AGV_O_P2=0 3000:AGV_O_P1=1 6000:AGV_I_P1=1");
}

TEST_CASE("A device that turns round needs the longer time to return") {
  const FaultyTables tables({"CYL_O_ADV", "CYL_I_ADV", "CYL_I_RET"}, R"({"name":"slow","of":"L_P_CYL","slower":4})");
  BenchPlant plant(tables);
  plant.set("CYL_O_ADV", 1).to(0).to(500);
  plant.start("slow").set("CYL_O_ADV", 0).to(500).to(2499);
  CHECK(plant.state("CYL") == "ADV->RET");
  plant.to(2500);
  CHECK(plant.state("CYL") == "RET");
}

TEST_CASE("Several factors apply one after the other, each rounded down") {
  const FaultyTables tables(kHall, R"({"name":"a","of":"L_P_AGV","slower":0.001},{"name":"b","of":"*","slower":1.5},
                                      {"name":"c","of":"L_P_AGV","slower":3})",
                            Reported().on_command("AGV", "P1", "P2", fixed(2'001)));
  BenchPlant plant(tables);
  plant.start("c").start("a").set("AGV_O_P2", 1).to(0);
  CHECK(plant.plant.next_due() == 6);  // 2001 -> 2 -> 6
  BenchPlant other(tables);
  other.start("c").start("b").start("a").set("AGV_O_P2", 1).to(0);
  CHECK(other.plant.next_due() == 9);  // 2001 -> 2 -> 3 -> 9: in the order of the description
  BenchPlant ordinary(tables);
  ordinary.start("L_P_AGV slow").start("b").set("AGV_O_P2", 1).to(0);
  CHECK(ordinary.plant.next_due() == 9'003);  // 2001 -> 3001 -> 9003: those of the description first
}

TEST_CASE("The default travel time and the return of a spring are longer, too") {
  const FaultyTables tables({"CYL_O_ADV", "CYL_I_ADV", "CYL_I_RET"}, R"({"name":"slow","of":"L_P_CYL","slower":4})");
  BenchPlant plant(tables);
  plant.start("slow").set("CYL_O_ADV", 1).to(0).to(3999);
  CHECK(plant.state("CYL") == "RET->ADV");
  plant.to(4000).set("CYL_O_ADV", 0).to(4000).to(7999);
  CHECK(plant.state("CYL") == "ADV->RET");
  plant.to(8000);
  CHECK(plant.state("CYL") == "RET");
}

TEST_CASE("A stuck device is disabled, a command to it is reported, and its start afterwards is not") {
  const FaultyTables tables(kHall, R"({"name":"jam","of":"L_P_AGV","stuck":true})");
  BenchPlant plant(tables);
  plant.to(0).start("jam").set("AGV_O_P2", 1).to(1000);
  CHECK(plant.state("AGV") == "[P1]");
  CHECK(plant.plant.is_stuck(0));
  CHECK(plant.reported() == "1000:disabled AGV_O_P2");
  plant.stop("jam").to(1500);
  CHECK(plant.state("AGV") == "P1->P2");
  CHECK(plant.reported() == "");
}

TEST_CASE("A device is disabled while a state or a malfunction disables it") {
  const FaultyTables tables({"DOOR_I_OPEN1", "DOOR_I_SHUT2", "AGV_I_P1", "AGV_I_P2", "AGV_O_P2"},
                            R"({"name":"jam","of":"L_P_AGV","stuck":true})",
                            Reported().disables("DOOR", "OPEN1", "AGV"));
  BenchPlant plant(tables);
  plant.start("jam").to(0).stop("jam").to(100);
  CHECK(plant.state("AGV") == "[P1]");
  CHECK_FALSE(plant.plant.is_stuck(1));
  plant.start("jam").put("DOOR", "SHUT2").to(200);
  CHECK(plant.state("AGV") == "[P1]");
  plant.set("AGV_O_P2", 1).to(300);
  plant.put("DOOR", "OPEN1").stop("jam").to(400);
  plant.put("DOOR", "SHUT2").to(500);
  CHECK(plant.state("AGV") == "P1->P2");
  CHECK(plant.reported() == "300:disabled AGV_O_P2 400:started AGV");  // the door enabled it
}

TEST_CASE("A device that is stuck in a state is put into it first") {
  const FaultyTables tables(kHall, R"({"name":"thrown","of":"L_P_AGV","stuck":"P2"})");
  BenchPlant plant(tables);
  plant.to(1000).start("thrown").to(1000);
  CHECK(plant.state("AGV") == "[P2]");
  CHECK(plant.changes() == "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:AGV_I_P2=1");
}

TEST_CASE("A force of a malfunction is above what moves an event, and below the user's force") {
  const FaultyTables tables(kHall, R"({"name":"blind","force":{"L_P_AGV_I_P1":false,"L_P_PE_I_PART":true}})");
  BenchPlant plant(tables);
  plant.to(1000).start("blind").to(2000);
  CHECK(plant.changes() == "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:PE_I_PART=1");
  plant.force("AGV_I_P1", 1).force("PE_I_PART", 0).to(3000);
  CHECK(plant.changes() == "2000:AGV_I_P1=1 2000:PE_I_PART=0");
  CHECK(plant.plant.malfunction_of_symbol(tables.symbol("AGV_I_P1")) == 0);
  plant.release("AGV_I_P1").release("PE_I_PART").to(4000);
  CHECK(plant.changes() == "3000:AGV_I_P1=0 3000:PE_I_PART=1");
  plant.stop("blind").to(5000);
  CHECK(plant.changes() == "4000:AGV_I_P1=1 4000:PE_I_PART=0");
}

TEST_CASE("A forced operation keeps what the PLC writes until the malfunction ends") {
  const FaultyTables tables(kHall, R"({"name":"wire","force":{"L_P_AGV_O_P2":false}})");
  BenchPlant plant(tables);
  plant.to(0).start("wire").set("AGV_O_P2", 1).to(1000);
  CHECK(plant.state("AGV") == "P1");
  plant.stop("wire").to(1500);
  CHECK(plant.state("AGV") == "P1->P2");
}

TEST_CASE("Numbers and all symbols on an address are forced, an inverted bit shows the value as it is written") {
  std::vector<Row> rows = bits({"L_P_AGV_I_P1", "L_P_AGV_I_P2", "L_P_AGV_O_P2"});
  rows.push_back({"LEFT", "", "BOOL", "FALSE", "%IX101"});
  rows.push_back({"RIGHT", "", "BOOL", "FALSE", "%IX101"});
  rows.push_back({"LEVEL", "", "INT", "5", "%IW30"});
  Reported reported;
  reported.description.inverted = {"L_P_AGV_I_P2"};
  const FaultyTables tables(rows, R"({"name":"all","force":{"RIGHT":true,"LEVEL":-3,"L_P_AGV_I_P2":false}})", reported);
  BenchPlant plant(tables);
  plant.to(0);
  CHECK(plant.on("AGV_I_P2"));
  plant.start("all").to(1000);
  CHECK(plant.on("LEFT"));
  CHECK(plant.on("RIGHT"));
  CHECK(static_cast<std::int64_t>(plant.value("LEVEL")) == -3);
  CHECK_FALSE(plant.on("AGV_I_P2"));
  plant.stop("all").to(2000);
  CHECK_FALSE(plant.on("LEFT"));
  CHECK(plant.value("LEVEL") == 5);
  CHECK(plant.on("AGV_I_P2"));
}

TEST_CASE("Of several malfunctions of a symbol the one that started last gives its value") {
  const FaultyTables tables(kHall, R"({"name":"on","force":{"L_P_PE_I_PART":true}},
                                      {"name":"off","force":{"L_P_PE_I_PART":false}})");
  BenchPlant plant(tables);
  plant.start("off").to(0).start("on").to(1000);
  CHECK(plant.on("PE_I_PART"));
  plant.start("off").to(2000);  // active already: it does not start again
  CHECK(plant.on("PE_I_PART"));
  plant.stop("off").start("off").to(3000);
  CHECK_FALSE(plant.on("PE_I_PART"));
  plant.stop("off").to(4000);
  CHECK(plant.on("PE_I_PART"));
}

TEST_CASE("A loose contact shows the contrary of what is below it, again and again") {
  const FaultyTables tables(kHall, R"({"name":"loose","flicker":{"symbol":"L_P_AGV_I_P2","every":"1s","for":"80ms"}})");
  BenchPlant plant(tables);
  plant.to(0).start("loose").to(2000);
  CHECK(plant.changes() == "0:AGV_I_P1=1 1000:AGV_I_P2=1 1080:AGV_I_P2=0");
  plant.set("AGV_O_P2", 1).to(2000).to(4500);  // it arrives at 3000, the next time begins at 2080
  CHECK(plant.changes() ==
        "2000:AGV_I_P1=0 2000:AGV_O_P2=1 2080:AGV_I_P2=1 2160:AGV_I_P2=0 3000:AGV_I_P2=1 3160:AGV_I_P2=0 "
        "3240:AGV_I_P2=1 4240:AGV_I_P2=0 4320:AGV_I_P2=1");
  plant.force("AGV_I_P2", 1).to(6000);
  CHECK(plant.changes() == "");
  plant.stop("loose").release("AGV_I_P2").to(9000);
  CHECK(plant.changes() == "");
}

}  // namespace
}  // namespace symplant::test
