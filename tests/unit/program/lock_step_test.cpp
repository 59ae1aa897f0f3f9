// Scans in lock step with a plant: when they take place, what they read, and when what they wrote counts.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "program_support.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using program::LockStep;
using tables::kSecond;
using tables::Time;

/// A plant with programs, and the changes of its symbols.
struct Bench final : engine::Observer {
  explicit Bench(const BenchTables& of) : tables(of), plant(of.rows), programs(plant, this) { plant.reset(0); }

  void instant(const engine::Instant& instant) noexcept override {
    for (const char* const name : {"AGV_O_P1", "AGV_O_P2", "AGV_I_P1", "AGV_I_P2"}) {
      const tables::SymbolRow& row = tables.rows.symbols[tables.symbol(name)];
      const bool on =
          row.direction() == tables::Direction::operation ? plant.operation(row.index) : plant.event(row.index);
      if (on == was[name]) continue;
      was[name] = on;
      changes +=
          (changes.empty() ? "" : " ") + std::to_string(instant.time / kMs) + ":" + name + "=" + (on ? "1" : "0");
    }
  }

  const BenchTables& tables;
  plant::OwnedPlant plant;
  LockStep programs;
  std::map<std::string, bool> was;
  std::string changes;
};

/// Sends the AGV to the other side each time it has arrived.
MadeProgram::Scan to_and_fro() {
  return [](const std::vector<std::uint8_t*>& io, std::int64_t) {
    if (*io[2] != 0) *io[0] = 0, *io[1] = 1;
    if (*io[3] != 0) *io[0] = 1, *io[1] = 0;
    return 0;
  };
}
const std::vector<symplant_variable> kAll = {writes("L_P_AGV_O_P1"), writes("L_P_AGV_O_P2"), reads("L_P_AGV_I_P1"),
                                             reads("L_P_AGV_I_P2")};

TEST_CASE("A scan reads at its time, and what it writes counts one period later") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(2 * kSecond);
  // A move takes 1 s. The scan at 1.1 s reads P2, which came on at 1.1 s; it writes for 1.2 s.
  CHECK(bench.changes ==
        "0:AGV_I_P1=1 100:AGV_O_P2=1 100:AGV_I_P1=0 1100:AGV_I_P2=1 1200:AGV_O_P1=1 1200:AGV_O_P2=0 1200:AGV_I_P2=0");
  CHECK(made.created == 1);
  bench.programs.end();
  CHECK(made.destroyed == 1);
}

TEST_CASE("With a shorter delay what a scan writes counts between two scans") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program, {.delay = 30 * kMs}) == "");
  bench.programs.advance_to(1500 * kMs);
  CHECK(bench.changes ==
        "0:AGV_I_P1=1 30:AGV_O_P2=1 30:AGV_I_P1=0 1030:AGV_I_P2=1 1130:AGV_O_P1=1 1130:AGV_O_P2=0 1130:AGV_I_P2=0");
}

TEST_CASE("A period or a delay that does not fit is rejected") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, {}, 20 * kMs);
  Bench bench(tables);
  CHECK(contains(bench.programs.add(made.program, {.period = 10 * kMs}), "has a period of 0.02 s, not 0.01 s"));
  CHECK(contains(bench.programs.add(made.program, {.delay = 21 * kMs}), "is not from 1 ns to its period"));
  CHECK(contains(bench.programs.add(made.program, {.delay = 0}), "is not from 1 ns to its period"));
  CHECK(bench.programs.add(made.program, {.period = 20 * kMs, .delay = 1}) == "");
}

TEST_CASE("A cell that no scan writes keeps the operation's value at the start") {
  const BenchTables tables(kCell);
  int first = -1;
  MadeProgram made(kAll, [&](const std::vector<std::uint8_t*>& io, std::int64_t now) {
    if (now == 0) first = *io[1];
    return 0;
  });
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(kSecond);
  CHECK(first == 0);
  CHECK(bench.changes == "0:AGV_I_P1=1");
}

TEST_CASE("A scan that fails ends the run with its number and its time, and nothing moves after it") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, [](const std::vector<std::uint8_t*>&, std::int64_t now) { return now == 120 * kMs ? 7 : 0; });
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(kSecond);
  REQUIRE(bench.programs.failed());
  CHECK(program::failure_words(*bench.programs.failure()) == "program `made` failed with 7 in scan 12 (0.12 s)");
  CHECK(bench.plant.now() == 120 * kMs);
}

TEST_CASE("A program that does not start ends the run before it begins") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll);
  made.starts = false;
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(kSecond);
  REQUIRE(bench.programs.failed());
  CHECK(program::failure_words(*bench.programs.failure()) == "program `made` did not start (0 s)");
}

TEST_CASE("A restart is a cold start: operations are off until the next scan's count") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(450 * kMs);
  CHECK(bench.programs.restart(0));
  CHECK_FALSE(bench.programs.restart(1));  // no program has that controller
  bench.programs.advance_to(450 * kMs);    // the instant of the restart
  bench.programs.advance_to(900 * kMs);
  CHECK(made.created == 2);
  CHECK(made.destroyed == 1);
  // The new program sees neither end, so that it sends the AGV nowhere.
  CHECK(bench.changes == "0:AGV_I_P1=1 100:AGV_O_P2=1 100:AGV_I_P1=0 450:AGV_O_P2=0");
}

TEST_CASE("A reset begins again at time 0") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(250 * kMs);
  bench.plant.reset(0);
  bench.programs.reset();
  bench.changes.clear();
  bench.was.clear();
  bench.programs.advance_to(150 * kMs);
  CHECK(made.created == 2);
  CHECK(bench.changes == "0:AGV_I_P1=1 100:AGV_O_P2=1 100:AGV_I_P1=0");
}

TEST_CASE("A restart before the first scan is the start itself") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  CHECK(bench.programs.restart(0));
  CHECK(made.created == 0);
  bench.programs.advance_to(250 * kMs);
  CHECK(made.created == 1);
  CHECK(made.destroyed == 0);
}

TEST_CASE("Links that share the plant's changed events find those of the whole cycle") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 10 * kMs);
  Bench bench(tables);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.share_events();
  bench.programs.advance_to(5 * kMs);
  bench.plant.forget_changed_events();
  bench.programs.advance_to(105 * kMs);  // I_P1 goes off at 20 ms; nothing changes after that
  CHECK_FALSE(bench.plant.changed_events().empty());
}

/// A stepper that does something at one of its calls.
struct Stepper final : exec::Stepper {
  explicit Stepper(plant::Plant& of) : plant(of) {}
  void advance_to(tables::Time time) noexcept override {
    ++ends;
    advance(time);
  }
  void advance_within(tables::Time time) noexcept override {
    ++parts;
    advance(time);
  }
  void hold() noexcept override {
    if (at_hold) at_hold();
  }
  bool frozen() const noexcept override { return holds; }
  bool over() const noexcept override { return false; }
  void advance(tables::Time time) noexcept {
    if (at_advance) std::exchange(at_advance, {})();
    plant.advance_to(std::max(time, plant.now()));
  }
  plant::Plant& plant;
  std::function<void()> at_advance = {};
  std::function<void()> at_hold = {};
  bool holds = false;
  int ends = 0;
  int parts = 0;
};

TEST_CASE("A cycle with several scans has one end") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 10 * kMs);
  Bench bench(tables);
  Stepper stepper(bench.plant);
  bench.programs.drive(&stepper);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.advance_to(45 * kMs);
  CHECK(stepper.ends == 1);
  CHECK(stepper.parts == 5);  // at 0, 10, 20, 30, 40 ms
  bench.programs.advance_to(50 * kMs);
  CHECK(stepper.ends == 2);
}

TEST_CASE("A reset that comes at time 0 calls no program that has ended") {
  const BenchTables tables(kCell);
  MadeProgram made(kAll, to_and_fro(), 100 * kMs);
  Bench bench(tables);
  Stepper stepper(bench.plant);
  bench.programs.drive(&stepper);
  REQUIRE(bench.programs.add(made.program) == "");
  stepper.at_advance = [&] {
    bench.plant.reset(0);
    bench.programs.reset();
  };
  bench.programs.advance_to(0);
  CHECK_FALSE(bench.programs.failed());
  CHECK(made.destroyed == 1);
  bench.programs.advance_to(250 * kMs);
  CHECK(made.created == 2);
}

TEST_CASE("What is done by hand while the plant is frozen is read by the next scan") {
  const BenchTables tables(kCell);
  bool at_p1 = true;
  MadeProgram made(
      kAll, [&](const std::vector<std::uint8_t*>& io, std::int64_t) { return at_p1 = *io[2] != 0, 0; }, 100 * kMs);
  Bench bench(tables);
  Stepper stepper(bench.plant);
  bench.programs.drive(&stepper);
  REQUIRE(bench.programs.add(made.program) == "");
  bench.programs.share_events();
  bench.programs.advance_to(150 * kMs);
  CHECK(at_p1);
  bench.plant.forget_changed_events();
  stepper.at_hold = [&] {
    bench.plant.force(tables.symbol("AGV_I_P1"), 0);
    bench.plant.advance_to(150 * kMs);
  };
  bench.programs.hold();
  bench.plant.forget_changed_events();  // as the cycle does
  bench.programs.advance_to(250 * kMs);
  CHECK_FALSE(at_p1);
}

}  // namespace
}  // namespace symplant::test
