// A plant's block: saved, copied, restored, rejected; and many plants in parallel.
#include <cstring>
#include <limits>

#include "support/plant_bench.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kCell = {"ARM_O_A1",  "ARM_I_A1",  "ARM_O_B2",    "ARM_I_B2",    "MC_I_IDLE1",
                                        "MC_O_RUN2", "MC_I_RUN2", "GATE_O_SHUT", "GATE_I_SHUT", "GATE_I_OPEN"};

Reported said() {
  const auto uniform = [](tables::Time min, tables::Time max) {
    return description::Duration{description::Duration::Kind::uniform, min * kMs, max * kMs};
  };
  Reported reported;
  reported.on_command("ARM", "A1", "B2", uniform(100, 300)).on_command("ARM", "B2", "A1", uniform(100, 300));
  reported.by_itself("MC", "RUN2", "IDLE1", uniform(50, 150), "L_P_ARM.B2").disables("GATE", "OPEN", "MC");
  reported.description.requirements.push_back({"arm answers", "", "L_P_ARM_O_B2", "L_P_ARM.B2", 250 * kMs});
  return reported;
}

/// Arming, random times, a condition, a disable, a requirement, a spring: every feature once.
const BenchTables& cell() {
  static const BenchTables tables(kCell, said());
  return tables;
}

/// Runs the script of commands with this number, from `first` on for `count` steps of 37 ms.
std::string run(BenchPlant& plant, std::uint64_t script, tables::Time first, tables::Time count) {
  static const std::vector<std::string> kWritten = {"ARM_O_A1", "ARM_O_B2", "MC_O_RUN2", "GATE_O_SHUT"};
  std::string text;
  for (tables::Time i = first; i < first + count; ++i) {
    std::uint64_t state = script * 1000 + static_cast<std::uint64_t>(i);
    state = (state ^ (state >> 30)) * 0xBF58'476D'1CE4'E5B9;
    state = (state ^ (state >> 27)) * 0x94D0'49BB'1331'11EB;
    plant.set(kWritten[state % 4], state >> 20 & 1).to(37 * i);
    if (state % 13 == 0) plant.force("ARM_O_B2", state >> 30 & 1);
    if (state % 13 == 1) plant.release("ARM_O_B2");
    if (state % 17 == 0) plant.put("GATE", (state >> 40 & 1) != 0 ? "SHUT" : "OPEN");
    text += plant.changes() + plant.reported() + " " + std::to_string(plant.plant.state_hash()) + "\n";
  }
  return text;
}

std::vector<std::byte> copy_of(const BenchPlant& plant) {
  const auto block = plant.plant.save();
  return {block.begin(), block.end()};
}

TEST_CASE("A restored plant continues bit-identically") {
  BenchPlant plant(cell());
  plant.plant.reset(3, 10 * kMs);
  run(plant, 1, 0, 40);
  const std::vector<std::byte> saved = copy_of(plant);
  const std::uint64_t hash = plant.plant.state_hash();
  const std::string once = run(plant, 1, 40, 60);
  const std::vector<std::byte> end = copy_of(plant);
  REQUIRE(plant.plant.restore(saved));
  CHECK(plant.plant.state_hash() == hash);
  CHECK(plant.plant.now() == 37 * 39 * kMs);
  CHECK(run(plant, 1, 40, 60) == once);
  CHECK(plant.plant.state_hash() == [&] {
    BenchPlant other(cell());
    REQUIRE(other.plant.restore(end));
    return other.plant.state_hash();
  }());
  CHECK(once.find("violated") != std::string::npos);  // the run was not empty
  CHECK(once.find("MC_I_RUN2=1") != std::string::npos);
}

TEST_CASE("Any plant of an equal model accepts the block, whatever its origin and history") {
  const BenchTables again(kCell, said());
  BenchPlant first(cell());
  BenchPlant second(again);
  first.plant.reset(3);
  run(first, 2, 0, 30);
  second.plant.reset(99, 5 * kMs);
  run(second, 7, 0, 55);
  REQUIRE(first.plant.model_hash() == second.plant.model_hash());
  REQUIRE(second.plant.restore(copy_of(first)));
  CHECK(second.plant.state_hash() == first.plant.state_hash());
  CHECK(run(second, 2, 30, 40) == run(first, 2, 30, 40));
}

TEST_CASE("Written values and actions that have not run yet are part of the block") {
  BenchPlant plant(cell());
  plant.to(0).set("ARM_O_B2", 1).force("GATE_O_SHUT", 1).put("MC", "RUN2");
  BenchPlant other(cell());
  REQUIRE(other.plant.restore(copy_of(plant)));
  CHECK(other.plant.next_due() == 0);
  other.to(0);
  plant.to(0);
  CHECK(other.state("ARM") == "A1->B2");
  CHECK(other.forced("GATE_O_SHUT"));
  CHECK(other.state("MC") == plant.state("MC"));
  CHECK(other.plant.state_hash() == plant.plant.state_hash());
}

TEST_CASE("A plant that has not started is saved and restored like any other") {
  BenchPlant plant(cell());
  plant.plant.reset(5);
  const std::vector<std::byte> fresh = copy_of(plant);
  const std::string once = run(plant, 4, 0, 30);
  REQUIRE(plant.plant.restore(fresh));
  CHECK(plant.plant.next_due() == 0);
  CHECK(run(plant, 4, 0, 30) == once);
}

TEST_CASE("A copy of its bytes is a complete block, at any alignment") {
  BenchPlant plant(cell());
  run(plant, 5, 0, 20);
  const auto block = plant.plant.save();
  std::vector<std::byte> bytes(block.size() + 1);
  std::memcpy(bytes.data() + 1, block.data(), block.size());
  const std::string once = run(plant, 5, 20, 20);
  BenchPlant other(cell());
  REQUIRE(other.plant.restore(std::span(bytes).subspan(1)));
  CHECK(run(other, 5, 20, 20) == once);
}

TEST_CASE("A block of another model, or too short, too long, empty or invalid, is rejected") {
  Reported slower = said();
  slower.description.defaults.travel = 2000 * kMs;  // of equal size and structure
  const BenchTables others(kCell, slower);
  BenchPlant other(others);
  BenchPlant plant(cell());
  REQUIRE(other.plant.model_hash() != plant.plant.model_hash());
  run(plant, 6, 0, 20);
  run(other, 6, 0, 20);
  const std::uint64_t hash = plant.plant.state_hash();
  const std::vector<std::byte> own = copy_of(plant);
  const std::vector<std::byte> foreign = copy_of(other);
  REQUIRE(own.size() == foreign.size());
  CHECK_FALSE(plant.plant.restore(foreign));
  CHECK_FALSE(plant.plant.restore(std::span(own).first(own.size() - 1)));
  CHECK_FALSE(plant.plant.restore(std::span(own).first(8)));
  CHECK_FALSE(plant.plant.restore({}));
  std::vector<std::byte> longer = own;
  longer.push_back(std::byte{0});
  CHECK_FALSE(plant.plant.restore(longer));
  CHECK_FALSE(plant.plant.restore(std::vector<std::byte>(own.size(), std::byte{0})));
  CHECK_FALSE(plant.plant.restore(std::vector<std::byte>(own.size(), std::byte{0xA5})));
  CHECK(plant.plant.state_hash() == hash);
  CHECK(copy_of(plant) == own);
}

TEST_CASE("Unread findings and stored changes are not part of a block") {
  BenchPlant plant(cell());
  plant.to(0);
  const std::vector<std::byte> saved = copy_of(plant);
  plant.set("ARM_O_A1", 1).set("ARM_O_B2", 1).to(1);
  REQUIRE(plant.plant.restore(saved));
  CHECK(plant.findings() == "1:conflicting ARM");
  BenchPlant other(cell());
  plant.to(0).set("ARM_O_A1", 1).set("ARM_O_B2", 1).to(1);
  REQUIRE(other.plant.restore(copy_of(plant)));
  CHECK(other.findings() == "");
}

TEST_CASE("A save changes nothing") {
  BenchPlant plant(cell());
  BenchPlant watched(cell());
  std::string text;
  for (tables::Time i = 0; i < 40; ++i) {
    copy_of(watched);
    text += run(watched, 8, i, 1);
  }
  CHECK(text == run(plant, 8, 0, 40));
}

TEST_CASE("The model_hash is that of the tables, and the same before and after a run") {
  BenchPlant plant(cell());
  const std::uint64_t hash = plant.plant.model_hash();
  CHECK(hash == tables::model_hash(cell().rows));
  run(plant, 9, 0, 20);
  plant.plant.reset(4);
  CHECK(plant.plant.model_hash() == hash);
}

TEST_CASE("Equal seeds give equal runs, another seed another run, and a reset forgets everything before") {
  BenchPlant plant(cell());
  plant.plant.reset(1);
  const std::string first = run(plant, 10, 0, 60);
  run(plant, 11, 60, 20);
  plant.plant.reset(2);
  const std::string second = run(plant, 10, 0, 60);
  plant.plant.reset(1);
  CHECK(run(plant, 10, 0, 60) == first);
  CHECK(second != first);
}

TEST_CASE("Small steps and one long step give the same state") {
  BenchPlant stepwise(cell());
  BenchPlant at_once(cell());
  for (BenchPlant* plant : {&stepwise, &at_once}) plant->to(0).set("ARM_O_B2", 1).set("MC_O_RUN2", 1).to(0);
  for (tables::Time i = 1; i <= 3000; ++i) stepwise.to(i);
  at_once.to(3000);
  CHECK(stepwise.plant.state_hash() == at_once.plant.state_hash());
  CHECK(stepwise.changes() == at_once.changes());
}

TEST_CASE("A thousand interleaved plants do the same as each alone") {
  constexpr std::uint64_t kPlants = 1000;
  constexpr tables::Time kSteps = 20;
  std::vector<std::unique_ptr<BenchPlant>> plants;
  for (std::uint64_t i = 0; i < kPlants; ++i) {
    plants.push_back(std::make_unique<BenchPlant>(cell()));
    plants.back()->plant.reset(i);
  }
  std::vector<std::string> together(kPlants);
  for (tables::Time step = 0; step < kSteps; ++step) {
    for (std::uint64_t i = 0; i < kPlants; ++i) together[i] += run(*plants[i], i, step, 1);
  }
  std::uint64_t different = 0;
  for (std::uint64_t i = 0; i < kPlants; ++i) {
    BenchPlant alone(cell());
    alone.plant.reset(i);
    INFO("plant " << i);
    REQUIRE(run(alone, i, 0, kSteps) == together[i]);
    different += together[i] != together[0] ? 1U : 0U;
  }
  CHECK(different > 990);
}

}  // namespace
}  // namespace symplant::test
