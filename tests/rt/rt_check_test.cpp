// --rt-check names the function, behavior and device that broke the rules.
#include "symplant/exec/rt_check.hpp"

#include <unistd.h>

#include <cstdlib>
#include <mutex>
#include <sstream>
#include <utility>

#include "rt/expect_nothing.hpp"
#include "support/plant_bench.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"

namespace symplant::test {
namespace {

using engine::Behaviour;
using engine::BehaviourView;

void* kept = nullptr;
std::mutex mutex;

/// Counts, and breaks a rule in each function.
constexpr Behaviour kFaulty{
    .memory_size = 8,
    .takes =
        [](BehaviourView& view, std::uint16_t transition) noexcept {
          const std::lock_guard lock(mutex);
          return view.model_takes(transition);
        },
    .entered =
        [](BehaviourView& view, std::uint8_t) noexcept {
          ++view.memory<std::uint64_t>();
          kept = std::realloc(kept, 4096 * view.memory<std::uint64_t>());
        },
    .left = [](BehaviourView&, std::uint8_t) noexcept { static_cast<void>(lseek(-1, 0, SEEK_SET)); },
};

constexpr Behaviour kSound{
    .memory_size = 8,
    .entered = [](BehaviourView& view, std::uint8_t) noexcept { ++view.memory<std::uint64_t>(); },
};

const BenchTables& two_arms() {
  static const BenchTables tables = [] {
    Reported reported;
    reported.device("ARM1").behaviour = "Sound";
    reported.device("ARM2").behaviour = "Faulty";
    return BenchTables(
        {"ARM1_O_A1", "ARM1_I_A1", "ARM1_O_B2", "ARM1_I_B2", "ARM2_O_A1", "ARM2_I_A1", "ARM2_O_B2", "ARM2_I_B2"},
        reported);
  }();
  return tables;
}

/// Both arms move to B2, each cycle under the guard.
exec::GuardReport there(plant::Plant& plant) {
  plant.set_operation(1, true);
  plant.set_operation(3, true);
  return exec::run_watched([&] {
    for (tables::Time now = 0; now <= 2 * tables::kSecond; now += 100 * kMs) {
      const exec::Guard guard;
      plant.advance_to(now);
    }
  });
}

TEST_CASE("A broken rule is reported with its act, function, behavior and device") {
  const Behaviour code[] = {kSound, kFaulty};
  const exec::WatchedBehaviours watched(two_arms().rows, code);
  plant::OwnedPlant plant(two_arms().rows, watched.watched());
  const exec::GuardReport report = there(plant);
  CHECK(plant.unit(0).state == 1);
  CHECK(plant.unit(1).state == 1);
  const auto lines = exec::rt_check_lines(report, two_arms().rows);
  const auto reported = [&](const std::string& begin) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return line.starts_with(begin); });
  };
  for (const std::string& line : lines) CHECK(line.find("ARM1") == line.npos);
  CHECK(reported("lock: pthread_mutex_lock, in `takes` of behavior `Faulty`, device L_P_ARM2, once"));
  CHECK(reported("heap: realloc, in `entered` of behavior `Faulty`, device L_P_ARM2, "));
  if (report.no_trap.empty())
    CHECK(reported("system call: lseek, in `left` of behavior `Faulty`, device L_P_ARM2, once"));
  expect_trap(report);
}

TEST_CASE("Watched behaviors do the same as the originals, and valid ones are clean") {
  const Behaviour code[] = {kSound, kSound};
  const exec::WatchedBehaviours watched(two_arms().rows, code);
  plant::OwnedPlant plant(two_arms().rows, watched.watched());
  plant::OwnedPlant plain(two_arms().rows, code);
  const exec::GuardReport report = there(plant);
  there(plain);
  CHECK(plant.state_hash() == plain.state_hash());
  expect_nothing(report);
  CHECK(exec::WatchedBehaviours(two_arms().rows, {}).watched().empty());
}

TEST_CASE("A run with --rt-check runs a number of cycles and exits with 1 and the names if rules were broken, else 0") {
  Reported reported;
  reported.device("ARM").behaviour = "Mine";
  reported.by_itself("ARM", "A1", "B2", fixed(50 * kMs)).by_itself("ARM", "B2", "A1", fixed(50 * kMs));
  const BenchTables tables({"ARM_I_A1", "ARM_I_B2"}, reported);
  host::RunOptions options;
  options.rt_check = 20;
  const auto checked = [&](const Behaviour& code) {
    const Behaviour all[] = {code};
    std::ostringstream out;
    std::ostringstream err;
    const int exit_code = host::run({.tables = tables.rows, .behaviours = all}, options, out, err);
    CHECK(err.str().empty());
    INFO(out.str());
    CHECK(out.str().find("rt-check: 20 cycles, ") != std::string::npos);
    return std::pair{exit_code, out.str()};
  };
  const auto [clean, nothing] = checked(kSound);
  CHECK(clean == host::kGood);
  CHECK(nothing.find("20 cycles, nothing found\n") != std::string::npos);
  const auto [broken, found] = checked(kFaulty);
  CHECK(broken == host::kFindings);
  CHECK(found.find("rt-check: heap: realloc, in `entered` of behavior `Mine`, device L_P_ARM, 4 times") !=
        std::string::npos);
  options.clock = host::RunOptions::Clock::real_time;
  options.cycle = 5 * kMs;
  CHECK(checked(kSound).first == host::kGood);
}

TEST_CASE("The unchecked parts are reported") {
  exec::GuardReport report;
  report.no_hooks = "a reason";
  report.no_trap = "another";
  report.count = 3;
  CHECK(exec::rt_check_lines(report, two_arms().rows) ==
        std::vector<std::string>{"and 3 more violations", "heap and locks were not checked: a reason",
                                 "system calls were not checked: another"});
}

}  // namespace
}  // namespace symplant::test
