// Malfunctions: what each kind does, and when they start and end.
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

/// A vehicle, a spring, and a sensor that no unit drives.
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

TEST_CASE("A stuck device is disabled; a command to it is reported, and its start afterwards is not") {
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

TEST_CASE("Numbers and all symbols on an address are forced; an inverted bit shows the value as it is written") {
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

TEST_CASE("A condition that begins to hold starts a malfunction in a further instant of that time") {
  const FaultyTables tables(kHall,
                            R"({"name":"blind","force":{"L_P_AGV_I_P2":false},"when":"L_P_AGV.P2","lasts":"500ms"})");
  BenchPlant plant(tables);
  plant.set("AGV_O_P2", 1).to(0).to(1400);
  CHECK(plant.changes() == "0:AGV_O_P2=1 1000:AGV_I_P2=1 1000:AGV_I_P2=0");
  CHECK(plant.malfunctions() == "1000:+blind condition");
  plant.to(3000);
  CHECK(plant.changes() == "1500:AGV_I_P2=1");
  CHECK(plant.malfunctions() == "1500:-blind end");  // the condition holds, but does not begin to
}

TEST_CASE("A malfunction starts by chance after time 0 and after each of its ends") {
  const FaultyTables tables(kHall, R"({"name":"noise","force":{"L_P_PE_I_PART":true},"chance":"2s","lasts":"500ms"})");
  BenchPlant plant(tables);
  plant.to(3000).start("noise").to(6000);
  CHECK(plant.malfunctions() ==
        "2000:+noise chance 2500:-noise end 3000:+noise hand 3500:-noise end 5500:+noise chance 6000:-noise end");
}

TEST_CASE("A malfunction becomes another one, or is remedied") {
  const FaultyTables tables(kHall, R"({"name":"sluggish","of":"L_P_AGV","slower":3,
                                       "becomes":{"after":"20s","unless":"L_P_BTN_I_RESET","start":"stuck"}},
                                      {"name":"stuck","of":"L_P_AGV","stuck":true})");
  BenchPlant plant(tables);
  plant.to(0).start("sluggish").to(25'000);
  CHECK(plant.malfunctions() == "0:+sluggish hand 20000:-sluggish becomes 20000:+stuck becomes");
  CHECK(plant.state("AGV") == "[P1]");
  plant.stop("stuck").start("sluggish").to(26'000);
  plant.input("BTN_I_RESET", 1);
  plant.to(27'000).to(60'000);
  CHECK(plant.malfunctions() == "25000:-stuck hand 25000:+sluggish hand 26000:-sluggish condition");
}

TEST_CASE("A malfunction that becomes itself begins again") {
  const FaultyTables tables(kHall, R"({"name":"again","force":{"L_P_PE_I_PART":true},
                                       "becomes":{"after":"1s","start":"again"}})");
  BenchPlant plant(tables);
  plant.start("again").to(1500);
  CHECK(plant.malfunctions() == "0:+again hand 1000:-again becomes 1000:+again becomes");
  CHECK(plant.plant.malfunction(0).since == 1000 * kMs);
}

TEST_CASE("A malfunction that makes its condition false and true again starts once at one time") {
  const FaultyTables tables(kHall, R"({"name":"ripple","force":{"L_P_PE_I_PART":true},"when":"not L_P_PE_I_PART",
                                       "becomes":{"after":"1h","unless":"L_P_PE_I_PART","start":"ripple"}})");
  BenchPlant plant(tables);
  plant.input("PE_I_PART", 1);
  plant.to(2000).input("PE_I_PART", 0);
  plant.changes();
  plant.to(5000);
  CHECK(plant.malfunctions() == "2000:+ripple condition 2000:-ripple condition");
  CHECK(plant.changes() == "2000:PE_I_PART=0 2000:PE_I_PART=1 2000:PE_I_PART=0");
}

TEST_CASE("Starting an active malfunction and stopping another one do nothing; an unknown number is refused") {
  const FaultyTables tables(kHall, R"({"name":"blind","force":{"L_P_PE_I_PART":true}})");
  BenchPlant plant(tables);
  plant.to(1000);
  CHECK(plant.plant.stop_malfunction(0));
  CHECK(plant.plant.start_malfunction(0));
  plant.to(2000);
  CHECK(plant.plant.start_malfunction(0));
  plant.to(3000);
  CHECK(plant.malfunctions() == "1000:+blind hand");
  CHECK(plant.plant.malfunction(0).since == 1000 * kMs);
  const auto units = static_cast<std::uint32_t>(tables.model().units.size());
  const std::uint32_t operation = 1 + 2 * units + 2 * tables.symbol("AGV_O_P2");
  for (const std::uint32_t number : {operation, operation + 1, 1000U}) {
    CHECK_FALSE(plant.plant.start_malfunction(number));
    CHECK_FALSE(plant.plant.stop_malfunction(number));
  }
}

TEST_CASE("Ordinary malfunctions need no description") {
  const BenchTables tables(kHall);
  BenchPlant plant(tables);
  plant.to(0).start("L_P_AGV slow").start("L_P_PE_I_PART stuck on").set("AGV_O_P2", 1).to(0);
  CHECK(plant.changes() == "0:AGV_I_P1=1 0:AGV_I_P1=0 0:AGV_O_P2=1 0:PE_I_PART=1");
  plant.to(2999);
  CHECK(plant.state("AGV") == "P1->P2");
  plant.to(3000).start("L_P_AGV_I_P2 stuck off").start("L_P_AGV stuck").to(9000);
  CHECK(plant.state("AGV") == "[P2]");
  CHECK_FALSE(plant.on("AGV_I_P2"));
  CHECK(plant.plant.active_malfunctions().size() == 4);
  plant.stop("L_P_AGV_I_P2 stuck off").stop("L_P_AGV stuck").to(9001);
  CHECK(plant.on("AGV_I_P2"));
  CHECK(plant.state("AGV") == "P2");
}

TEST_CASE("No more than 64 ordinary malfunctions are active") {
  std::vector<std::string> names;
  for (int i = 0; i < 70; ++i) names.push_back("PE" + std::to_string(i) + "_I_PART");
  const FaultyTables tables(names, R"({"name":"one","force":{"L_P_PE0_I_PART":true}})");
  BenchPlant plant(tables);
  const std::uint32_t first = 1 + 2 * static_cast<std::uint32_t>(tables.model().units.size());
  for (std::uint32_t i = 0; i < 64; ++i) REQUIRE(plant.plant.start_malfunction(first + 2 * i));
  CHECK_FALSE(plant.plant.start_malfunction(first + 2 * 64));
  CHECK(plant.plant.start_malfunction(first));  // it is active already
  CHECK(plant.plant.start_malfunction(0));
  CHECK(plant.plant.stop_malfunction(first + 2 * 7));
  CHECK(plant.plant.start_malfunction(first + 2 * 64));
  plant.to(1000);
  CHECK(plant.plant.active_malfunctions().size() == 65);
}

TEST_CASE("A plant restored from a block has its malfunctions; one without them ignores that they exist") {
  const FaultyTables tables(kHall, R"({"name":"slow","of":"L_P_AGV","slower":3,"lasts":{"min":"1s","max":"9s"}},
                                      {"name":"loose","flicker":{"symbol":"L_P_PE_I_PART",
                                       "every":{"min":"1s","max":"5s"},"for":"80ms"},"chance":{"mean":"3s","sigma":"1s"}})");
  const auto act = [](BenchPlant& plant) {
    for (tables::Time time = 5000; time <= 60'000; time += 2500) {
      plant.set("AGV_O_P2", time % 5000 == 0 ? 1 : 0).set("AGV_O_P1", time % 5000 == 0 ? 0 : 1);
      if (time % 7500 == 0) plant.start("slow");
      plant.to(time);
    }
    return plant.changes() + plant.malfunctions() + std::to_string(plant.plant.state_hash());
  };
  BenchPlant plant(tables);
  plant.plant.reset(7);
  plant.start("slow").start("L_P_AGV_I_P1 stuck on").to(4000);
  BenchPlant other(tables);
  REQUIRE(other.plant.restore(plant.plant.save()));
  CHECK(other.plant.state_hash() == plant.plant.state_hash());
  CHECK(other.plant.active_malfunctions().size() == plant.plant.active_malfunctions().size());
  plant.changes();
  plant.malfunctions();
  CHECK(act(other) == act(plant));
}

TEST_CASE(
    "The state hash is another for each active malfunction, and that of a plant without malfunctions after their end") {
  const BenchTables tables(kHall);
  BenchPlant plant(tables);
  plant.to(1000);
  const std::uint64_t without = plant.plant.state_hash();
  plant.start("L_P_BTN_I_RESET stuck off").to(1000);
  const std::uint64_t with = plant.plant.state_hash();
  CHECK(with != without);
  plant.stop("L_P_BTN_I_RESET stuck off").start("L_P_PE_I_PART stuck off").to(1000);
  CHECK(plant.plant.state_hash() != with);
  plant.stop("L_P_PE_I_PART stuck off").to(1000);
  CHECK(plant.plant.state_hash() == without);
}

TEST_CASE("A reset ends all malfunctions") {
  const FaultyTables tables(kHall, R"({"name":"jam","of":"L_P_AGV","stuck":true})");
  BenchPlant plant(tables);
  plant.start("jam").start("L_P_PE_I_PART stuck on").to(1000);
  plant.plant.reset();
  plant.to(0);
  CHECK(plant.plant.active_malfunctions().empty());
  CHECK(plant.state("AGV") == "P1");
  CHECK_FALSE(plant.on("PE_I_PART"));
}

TEST_CASE("A view shows since when a malfunction is active and when it changes by itself") {
  const FaultyTables tables(kHall, R"({"name":"loose","flicker":{"symbol":"L_P_PE_I_PART","every":"3s","for":"1s"},
                                       "lasts":"3500ms"},{"name":"cable","lose":true,"chance":"9s"})");
  BenchPlant plant(tables);
  plant.to(0);
  CHECK_FALSE(plant.plant.malfunction(0).active);
  CHECK(plant.plant.malfunction(0).next_due == tables::kNever);
  CHECK(plant.plant.malfunction(1).next_due == 9000 * kMs);
  CHECK_FALSE(plant.plant.is_cut(0));
  plant.to(500).start("loose").start("cable").to(1000);
  CHECK(plant.plant.malfunction(0).since == 500 * kMs);
  CHECK(plant.plant.malfunction(0).next_due == 3500 * kMs);
  CHECK(plant.plant.is_cut(0));
  plant.to(3500);
  CHECK(plant.plant.malfunction(0).next_due == 4000 * kMs);  // its end
}

}  // namespace
}  // namespace symplant::test
