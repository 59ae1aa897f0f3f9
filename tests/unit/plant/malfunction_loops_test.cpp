// Malfunctions that start and end without end within a millisecond.
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

using engine::MalfunctionChange;

const std::vector<std::string> kEye = {"EYE_I_PART", "GATE_I_CLEAR", "AGV_O_P2"};

/// It starts every nanosecond, and so do the ones that it becomes.
constexpr const char* kRestless =
    R"({"name":"eye","force":{"L_P_EYE_I_PART":true},"when":"not L_P_EYE_I_PART","becomes":{"after":"1ns","start":"clear"}},
       {"name":"calm","of":"L_P_AGV","slower":2},
       {"name":"clear","force":{"L_P_GATE_I_CLEAR":true},"lasts":"1ns"})";

/// Starts and ends, in all instants.
class Changes final : public engine::Observer {
 public:
  void instant(const engine::Instant& instant) noexcept override {
    count += instant.malfunctions.size();
    for (const MalfunctionChange& change : instant.malfunctions) last.push_back({instant.time, change});
    if (last.size() > 8) last.erase(last.begin(), last.end() - 8);
  }
  std::size_t count = 0;
  std::vector<std::pair<tables::Time, MalfunctionChange>> last;
};

TEST_CASE("Malfunctions that start and end more than 10,000 times within 1 ms end, and a finding names them") {
  const FaultyTables tables(kEye, kRestless);
  BenchPlant plant(tables);
  Changes changes;
  plant.plant.advance_to(2 * kMs, &changes);
  // In each ns `eye` ends and starts, and `clear` starts or ends: 10,000 are exceeded after 3,334 ns.
  REQUIRE(changes.count > 10'000);
  CHECK(changes.count < 10'010);
  CHECK(plant.findings() == "0:loop eye+ 0:loop clear");
  CHECK(plant.plant.active_malfunctions().empty());
  CHECK_FALSE(plant.on("EYE_I_PART"));
  CHECK(changes.last.back().second.by == MalfunctionChange::By::end);
  CHECK(changes.last.back().first == 3334);
}

TEST_CASE("A malfunction that was frozen in a loop stays inactive until reset, and others still start") {
  const FaultyTables tables(kEye, kRestless);
  BenchPlant plant(tables);
  plant.to(5).start("eye").start("clear").start("calm").to(6);
  CHECK(plant.plant.active_malfunctions().size() == 1);
  CHECK(plant.plant.malfunction(0).next_due == tables::kNever);
  plant.input("EYE_I_PART", 1);
  plant.to(7).input("EYE_I_PART", 0);
  plant.malfunctions();
  plant.to(8);
  CHECK(plant.malfunctions().empty());
  CHECK(plant.findings() == "0:loop eye+ 0:loop clear");
  plant.plant.reset(0);
  plant.to(1);
  CHECK(plant.findings() == "0:loop eye+ 0:loop clear");
}

TEST_CASE("A malfunction of chance that is frozen in a loop starts no more") {
  const FaultyTables tables(kEye, R"({"name":"noise","force":{"L_P_EYE_I_PART":true},"chance":"1ns","lasts":"1ns"})");
  BenchPlant plant(tables);
  plant.to(10);
  CHECK(plant.findings() == "0:loop noise");
  plant.malfunctions();
  plant.to(1000);
  CHECK(plant.malfunctions().empty());
}

TEST_CASE("10,000 starts and ends within each millisecond are no loop") {
  const FaultyTables tables(kEye,
                            R"({"name":"noise","force":{"L_P_EYE_I_PART":true},"chance":"100ns","lasts":"100ns"})");
  BenchPlant plant(tables);
  Changes changes;
  plant.plant.advance_to(3 * kMs, &changes);
  CHECK(changes.count == 30'000);
  CHECK(plant.findings().empty());
}

TEST_CASE("A saved plant continues to count starts and ends, its hash shows that a malfunction is frozen") {
  const FaultyTables tables(kEye, R"({"name":"noise","force":{"L_P_EYE_I_PART":true},"chance":"90ns","lasts":"90ns"})");
  BenchPlant plant(tables);
  plant.plant.advance_to(kMs / 2);
  const std::vector<std::byte> block(plant.plant.save().begin(), plant.plant.save().end());
  plant.plant.advance_to(kMs);
  const std::uint64_t hash = plant.plant.state_hash();
  BenchPlant other(tables);
  REQUIRE(other.plant.restore(block));
  other.plant.advance_to(kMs);
  CHECK(other.plant.state_hash() == hash);
  CHECK(other.findings() == "0:loop noise");
}

TEST_CASE("Those that start once while others loop stay active") {
  const FaultyTables tables(
      kEye, std::string(kRestless) + R"(,{"name":"once","of":"L_P_AGV","stuck":true,"when":"L_P_GATE_I_CLEAR"})");
  BenchPlant plant(tables);
  plant.to(5);
  CHECK(plant.findings() == "0:loop eye+ 0:loop clear");
  REQUIRE(plant.plant.active_malfunctions().size() == 1);
  CHECK(plant.plant.active_malfunctions().front().number == 3);
}

}  // namespace
}  // namespace symplant::test
