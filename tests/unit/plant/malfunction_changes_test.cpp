// Malfunctions: when they start and end; views, hashes and saved plants.
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

/// A vehicle; a sensor and a button that no unit drives.
const std::vector<std::string> kFaultyHall = {"AGV_I_P1", "AGV_I_P2",  "AGV_O_P2",
                                              "AGV_O_P1", "PE_I_PART", "BTN_I_RESET"};

TEST_CASE("A condition that begins to hold starts a malfunction in a further instant of that time") {
  const FaultyTables tables(kFaultyHall,
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
  const FaultyTables tables(kFaultyHall,
                            R"({"name":"noise","force":{"L_P_PE_I_PART":true},"chance":"2s","lasts":"500ms"})");
  BenchPlant plant(tables);
  plant.to(3000).start("noise").to(6000);
  CHECK(plant.malfunctions() ==
        "2000:+noise chance 2500:-noise end 3000:+noise hand 3500:-noise end 5500:+noise chance 6000:-noise end");
}

TEST_CASE("A malfunction becomes another one, or is remedied") {
  const FaultyTables tables(kFaultyHall, R"({"name":"sluggish","of":"L_P_AGV","slower":3,
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
  const FaultyTables tables(kFaultyHall, R"({"name":"again","force":{"L_P_PE_I_PART":true},
                                       "becomes":{"after":"1s","start":"again"}})");
  BenchPlant plant(tables);
  plant.start("again").to(1500);
  CHECK(plant.malfunctions() == "0:+again hand 1000:-again becomes 1000:+again becomes");
  CHECK(plant.plant.malfunction(0).since == 1000 * kMs);
}

TEST_CASE("A malfunction that makes its condition false and true again starts once at one time") {
  const FaultyTables tables(kFaultyHall, R"({"name":"ripple","force":{"L_P_PE_I_PART":true},"when":"not L_P_PE_I_PART",
                                       "becomes":{"after":"1h","unless":"L_P_PE_I_PART","start":"ripple"}})");
  BenchPlant plant(tables);
  plant.input("PE_I_PART", 1);
  plant.to(2000).input("PE_I_PART", 0);
  plant.changes();
  plant.to(5000);
  CHECK(plant.malfunctions() == "2000:+ripple condition 2000:-ripple condition");
  CHECK(plant.changes() == "2000:PE_I_PART=0 2000:PE_I_PART=1 2000:PE_I_PART=0");
}

TEST_CASE("Starting an active malfunction and stopping another one do nothing, an unknown number is refused") {
  const FaultyTables tables(kFaultyHall, R"({"name":"blind","force":{"L_P_PE_I_PART":true}})");
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
  const BenchTables tables(kFaultyHall);
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

TEST_CASE("A plant restored from a block has its malfunctions, one without them ignores that they exist") {
  const FaultyTables tables(kFaultyHall, R"({"name":"slow","of":"L_P_AGV","slower":3,"lasts":{"min":"1s","max":"9s"}},
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
  const BenchTables tables(kFaultyHall);
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
  const FaultyTables tables(kFaultyHall, R"({"name":"jam","of":"L_P_AGV","stuck":true})");
  BenchPlant plant(tables);
  plant.start("jam").start("L_P_PE_I_PART stuck on").to(1000);
  plant.plant.reset();
  plant.to(0);
  CHECK(plant.plant.active_malfunctions().empty());
  CHECK(plant.state("AGV") == "P1");
  CHECK_FALSE(plant.on("PE_I_PART"));
}

TEST_CASE("A view shows since when a malfunction is active and when it changes by itself") {
  const FaultyTables tables(kFaultyHall,
                            R"({"name":"loose","flicker":{"symbol":"L_P_PE_I_PART","every":"3s","for":"1s"},
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
