// Running a plant: the end of virtual time, errors and exit codes.
#include "symplant/host/run.hpp"

#include <sstream>
#include <vector>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::test {
namespace {

/// One unit that cycles automatically, 1 s per state.
struct Clockwork {
  std::vector<tables::Transition> transitions{{0, 1, tables::kNoOperation, false, tables::kNoCondition, true},
                                              {1, 0, tables::kNoOperation, false, tables::kNoCondition, true}};
  std::vector<tables::EventMasks> enter{{1, 0}, {2, 0}};
  std::vector<tables::EventMasks> leave{{0, 1}, {0, 2}};
  std::vector<tables::TransitionTimes> times{{tables::kSecond, 0}};
  std::vector<tables::TypeRow> types{
      {0, 2, 2, tables::kNoState, tables::Actuation::latched, transitions, enter, leave, {}, times}};
  std::vector<tables::UnitRow> units{{0, 0, 1, 0, 0, 0}};
  tables::PlantTables tables = rows();

  tables::PlantTables rows() const {
    tables::PlantTables all = bare_tables("clockwork", 0, 64);
    all.types = types;
    all.units = units;
    all.list_names = {"none", 5};
    return all;
  }
};

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

Outcome run(const tables::PlantTables& tables, const host::RunOptions& options) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = host::run({.tables = tables}, options, out, err);
  return {code, out.str(), err.str()};
}

TEST_CASE("Virtual time without an end runs for an hour of plant time, with a message") {
  const Clockwork plant;
  const Outcome outcome = run(plant.tables, {});
  CHECK(outcome.code == host::kGood);
  CHECK(contains(outcome.out, "ended at 3600 s of plant time"));
  CHECK(contains(outcome.out, "--until"));
}

TEST_CASE("Virtual time ends at the requested time") {
  const Clockwork plant;
  host::RunOptions options;
  options.until = 2500 * tables::kMillisecond;
  CHECK(contains(run(plant.tables, options).out, "ended at 2.5 s: --until is reached"));
}

TEST_CASE("Virtual time ends when nothing is due") {
  tables::PlantTables empty = bare_tables("empty", 0, 0);
  empty.list_names = {"none", 5};
  CHECK(contains(run(empty, {}).out, "nothing more will happen"));
}

TEST_CASE("Virtual time with a link is rejected, with the loop it is accepted") {
  const Clockwork plant;
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::virtual_time;
  options.links = {"modbus-tcp-server://127.0.0.1:0"};
  CHECK(run(plant.tables, options).code == host::kBadInput);
  options.links = {"loop:"};
  options.until = tables::kSecond;
  CHECK(run(plant.tables, options).code == host::kGood);
}

TEST_CASE("An unwritable trace is a fault of the environment") {
  const Clockwork plant;
  host::RunOptions options;
  options.trace = "/no/such/folder/trace.jsonl";
  const Outcome outcome = run(plant.tables, options);
  CHECK(outcome.code == host::kEnvironment);
  CHECK(contains(outcome.err, "/no/such/folder/trace.jsonl"));
}

TEST_CASE("Real time ends as requested, and reports its cycles") {
  const Clockwork plant;
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::real_time;
  options.until = 50 * tables::kMillisecond;
  const Outcome outcome = run(plant.tables, options);
  CHECK(outcome.code == host::kGood);
  CHECK(contains(outcome.out, "ended at 0.05 s"));
}

TEST_CASE("A spin that is not shorter than the cycle is a usage error") {
  const Clockwork plant;
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::real_time;
  options.until = 20 * tables::kMillisecond;
  options.spin = options.cycle;
  const Outcome outcome = run(plant.tables, options);
  CHECK(outcome.code == host::kBadInput);
  CHECK(contains(outcome.err, "not shorter than the cycle of 0.01 s"));
  options.spin = options.cycle - 1;
  CHECK(run(plant.tables, options).code == host::kGood);
}

TEST_CASE("Real-time options are reported as without effect in virtual time, each given one") {
  const Clockwork plant;
  host::RunOptions options;
  options.until = tables::kSecond;
  CHECK(run(plant.tables, options).err.empty());
  options.real_time.priority = 50;
  const Outcome outcome = run(plant.tables, options);
  CHECK(outcome.code == host::kGood);
  CHECK(outcome.err ==
        "warning: `--priority` has no effect in virtual time; to run in real time, add `--clock real`\n");
  options.real_time = {};
  options.on_loss = link::OnLoss::zero;
  options.cycle_given = true;
  options.late_given = true;
  CHECK(run(plant.tables, options).err ==
        "warning: `--cycle`, `--on-loss`, `--late` have no effect in virtual time; to run in real time, add `--clock "
        "real`\n");
}

TEST_CASE("A guarded run in virtual time has a cycle") {
  const Clockwork plant;
  host::RunOptions options;
  options.rt_check = 3;
  options.cycle_given = true;
  CHECK(run(plant.tables, options).err.empty());
}

TEST_CASE("The option --on-loss is reported as without effect if no link can be lost") {
  const Clockwork plant;
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::real_time;
  options.until = 20 * tables::kMillisecond;
  options.on_loss = link::OnLoss::zero;
  options.cycle_given = true;
  CHECK(contains(run(plant.tables, options).err, "warning: `--on-loss` has no effect without a link"));
  options.links = {"modbus-tcp-server://127.0.0.1:0"};
  CHECK_FALSE(contains(run(plant.tables, options).err, "--on-loss"));
}

TEST_CASE("A file size limit is reported as without effect if no file is written") {
  const Clockwork plant;
  host::RunOptions options;
  options.until = tables::kSecond;
  options.trace_limit = 4096;
  CHECK(contains(run(plant.tables, options).err, "warning: `--trace-limit` has no effect without `--trace`"));
  options.trace = "/dev/null";
  CHECK(run(plant.tables, options).err.empty());
}

TEST_CASE("Late cycles are caught up to a number, ten by default, or slipped") {
  CHECK(host::parse_late("catch-up") == 10);
  CHECK(host::parse_late("catch-up:0") == 0);
  CHECK(host::parse_late("catch-up:25") == 25);
  CHECK(host::parse_late("slip") == 0);
  for (const char* wrong :
       {"", "catch-up:", "catch-up:-1", "catch-up:1000001", "catch-up: 3", "catch-up:3x", "late", "catch", "slip:3"}) {
    CHECK_FALSE(host::parse_late(wrong));
  }
}

}  // namespace
}  // namespace symplant::test
