// The class of a run with a fault.
#include "campaign/judge.hpp"

#include <algorithm>
#include <string_view>

#include "campaign_support.hpp"
#include "support/strings.hpp"

namespace symplant::campaign {
namespace {

using test::contains;
using Sets = std::vector<Bench::Set>;

/// The motor runs while A is on: twice for a second. The longest pause is 1.01 s, at the start.
const Sets kBase = {{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}, {2000, "L_P_A_I_X", 0}, {2010, "L_P_M_O_RUN", 0},
                    {3000, "L_P_A_I_X", 1}, {3010, "L_P_M_O_RUN", 1}, {4000, "L_P_A_I_X", 0}, {4010, "L_P_M_O_RUN", 0}};

/// The base case with other changes, by time.
Sets with(Sets more) {
  Sets all = kBase;
  all.insert(all.end(), more.begin(), more.end());
  std::stable_sort(all.begin(), all.end(), [](const Bench::Set& a, const Bench::Set& b) { return a.ms < b.ms; });
  return all;
}

struct Cycle : Bench {
  Cycle() { set_base(kBase); }
};

TEST_CASE("Nothing that a scan reads differs: no effect") {
  const Cycle bench;
  CHECK(bench.base.pause == 1010 * kMs);
  CHECK(bench.judged(kBase).is == Class::no_effect);
  CHECK(bench.judged(kBase).seen_at == -1);
  // On and off between two scans.
  CHECK(bench.judged(with({{2501, "L_P_B_I_X", 1}, {2509, "L_P_B_I_X", 0}})).is == Class::no_effect);
  // A change at the time of a scan is read by it.
  const Result read = bench.judged(with({{2510, "L_P_B_I_X", 1}, {2519, "L_P_B_I_X", 0}}));
  CHECK(read.is == Class::undetected);
  CHECK(read.seen_at == 2510 * kMs);
  CHECK(read.seen == "L_P_B_I_X on");
  // What is late, but within the same scan, is read at the same time.
  Sets late = kBase;
  for (Bench::Set& set : late) set.ms -= set.ms % 1000 == 0 ? 3 : 0;
  CHECK(bench.judged(late).is == Class::no_effect);
  for (Bench::Set& set : late) set.ms += set.ms % 10 == 7 ? 4 : 0;
  CHECK(bench.judged(late).is != Class::no_effect);
}

TEST_CASE("The first scan that reads something else counts, also of numbers") {
  const Cycle bench;
  const Result result = bench.judged(with({{1201, "L_P_N_I_SPEED", 7}, {1500, "L_P_B_I_X", 1}}));
  CHECK(result.seen == "L_P_N_I_SPEED 7");
  CHECK(result.seen_at == 1210 * kMs);
  CHECK(result.is == Class::undetected);
  // It is the value of the run, not that of the base case.
  Sets missing = kBase;
  std::erase_if(missing, [](const Bench::Set& set) { return set.ms == 3000; });
  CHECK(bench.judged(missing).seen == "L_P_A_I_X off");
  CHECK(bench.judged(missing).seen_at == 3000 * kMs);
}

TEST_CASE("The operations are those of the base case: undetected") {
  const Cycle bench;
  const Result result = bench.judged(with({{500, "L_P_B_I_X", 1}}));
  CHECK(result.is == Class::undetected);
  CHECK(contains(result.reaction, "the operations are those without the fault"));
  CHECK(result.on.empty());
  CHECK(result.end == "as without the fault");
  // One change more or less is a difference.
  CHECK(bench.judged(with({{500, "L_P_B_I_X", 1}, {4500, "L_P_M_O_BACK", 1}})).is == Class::other);
}

TEST_CASE("An alarm that is off without the fault comes on: detected, with the time from the first effect") {
  const Cycle bench;
  const Result result = bench.judged(with({{1204, "L_P_B_I_X", 1}, {1500, "L_P_HORN_O_ON", 1}}));
  CHECK(result.is == Class::detected);
  CHECK(result.alarms == std::vector<std::string>{"L_P_HORN_O_ON"});
  CHECK(result.detection == 290 * kMs);
  // A number that is no longer 0 is one, too.
  const Result number = bench.judged(with({{1200, "L_P_B_I_X", 1}, {1400, "L_P_CODE_O_FAULT", 12}}));
  CHECK(number.is == Class::detected);
  CHECK(number.alarms == std::vector<std::string>{"L_P_CODE_O_FAULT"});
  CHECK(number.detection == 200 * kMs);
  // It goes before what else the operations do.
  CHECK(bench.judged({{1204, "L_P_B_I_X", 1}, {1500, "L_P_HORN_O_ON", 1}}).is == Class::detected);
}

TEST_CASE("An alarm that comes on in the base case, too, is not one of the fault, even if it is late") {
  Bench bench;
  const Sets beeps = {{1000, "L_P_A_I_X", 1},     {1010, "L_P_M_O_RUN", 1},   {2010, "L_P_M_O_RUN", 0},
                      {2500, "L_P_HORN_O_ON", 1}, {2600, "L_P_HORN_O_ON", 0}, {3500, "L_P_M_O_RUN", 1}};
  bench.set_base(beeps);
  Sets late = beeps;
  for (Bench::Set& set : late) set.ms += 300;
  const Result result = bench.judged(late);
  CHECK(result.is == Class::other);
  CHECK(result.alarms.empty());
  late.push_back({4500, "L_P_HORN_O_ON", 1});
  const Result more = bench.judged(late);
  CHECK(more.is == Class::detected);
  CHECK(more.detection == 4500 * kMs - more.seen_at);  // not that of the late one
  // So it is with numbers.
  Bench numbers;
  numbers.set_base({{1000, "L_P_A_I_X", 1}, {2500, "L_P_CODE_O_FAULT", 3}, {2600, "L_P_CODE_O_FAULT", 0}});
  CHECK(numbers.judged({{1300, "L_P_A_I_X", 1}, {2800, "L_P_CODE_O_FAULT", 3}, {2900, "L_P_CODE_O_FAULT", 0}}).is ==
        Class::other);
  CHECK(numbers.judged({{1300, "L_P_A_I_X", 1}, {2400, "L_P_CODE_O_FAULT", 3}, {2900, "L_P_CODE_O_FAULT", 0}}).is ==
        Class::detected);
}

TEST_CASE("A heartbeat is no sign of work") {
  Bench bench;
  Sets beats = kBase;
  for (std::int64_t ms = 5; ms < 5000; ms += 100) {
    beats.push_back({ms, "L_P_M_O_BACK", static_cast<std::uint64_t>((ms / 100 + 1) % 2)});
  }
  const auto by_time = [](const Bench::Set& a, const Bench::Set& b) { return a.ms < b.ms; };
  std::stable_sort(beats.begin(), beats.end(), by_time);
  bench.base.paced = paced_operations(bench.log(beats), bench.base.operations);
  CHECK_FALSE(bench.base.paced[bench.plant.symbol("L_P_M_O_BACK")]);
  CHECK(bench.base.paced[bench.plant.symbol("L_P_M_O_RUN")]);
  bench.set_base(beats);
  CHECK(bench.base.pause == 1010 * kMs);
  Sets stuck = {{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}};
  for (const Bench::Set& set : beats) {
    if (set.symbol == std::string_view("L_P_M_O_BACK")) stuck.push_back(set);
  }
  std::stable_sort(stuck.begin(), stuck.end(), by_time);
  CHECK(bench.judged(stuck).is == Class::stopped);
  // If nothing else changes, it is all that shows work.
  const RunLog only = bench.log({{100, "L_P_M_O_BACK", 1},
                                 {200, "L_P_M_O_BACK", 0},
                                 {300, "L_P_M_O_BACK", 1},
                                 {400, "L_P_M_O_BACK", 0},
                                 {500, "L_P_M_O_BACK", 1},
                                 {600, "L_P_M_O_BACK", 0},
                                 {700, "L_P_M_O_BACK", 1},
                                 {800, "L_P_M_O_BACK", 0}},
                                900);
  CHECK(paced_operations(only, bench.base.operations) == bench.base.operations);
}

TEST_CASE("A program that goes on after the run has not stopped") {
  const Cycle bench;
  const Sets stuck = {{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}};
  Result result;
  judge(bench.base, bench.facts, bench.log(stuck), {}, result, 6000 * kMs);
  CHECK(result.is == Class::other);
  CHECK(contains(result.reaction, "no operation changes from 1.01 s to 6 s"));
}

TEST_CASE("No operation changes for too long at the end: stopped, with what stays on") {
  const Cycle bench;
  const Sets stuck = {{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}};
  const Result result = bench.judged(stuck);
  CHECK(result.is == Class::stopped);
  CHECK(contains(result.reaction, "no operation changes after 1.01 s"));
  CHECK(result.on == std::vector<std::string>{"L_P_M_O_RUN"});
  CHECK(bench.judged({{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}, {1200, "L_P_M_O_RUN", 0}}).end == "all off");
  // As long as in the base case is not too long; a longer pause after which it goes on is not a stop.
  CHECK(bench.judged({{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}, {3990, "L_P_M_O_RUN", 0}}).is == Class::other);
  CHECK(bench.judged({{1000, "L_P_A_I_X", 1}, {1010, "L_P_M_O_RUN", 1}, {3989, "L_P_M_O_RUN", 0}}).is ==
        Class::stopped);
}

TEST_CASE("A violated requirement goes before all others") {
  const Cycle bench;
  RunLog log = bench.log(kBase);
  log.violation = Violation{1700 * kMs, 0};
  const Result result = bench.judged(log);
  CHECK(result.is == Class::violated);
  CHECK(contains(result.reaction, "violates `never both` at 1.7 s"));
  log = bench.log(with({{1204, "L_P_B_I_X", 1}, {1500, "L_P_HORN_O_ON", 1}}));
  log.violation = Violation{1700 * kMs, 0};
  const Result detected = bench.judged(log);
  CHECK(detected.is == Class::violated);
  CHECK(detected.detection == 290 * kMs);
}

TEST_CASE("A program whose controller is lost reads nothing from then on") {
  const Cycle bench;
  Fault fault;
  fault.controllers = {0};
  const Result result = bench.judged(bench.log({{1000, "L_P_A_I_X", 1}}), fault);
  CHECK(result.is == Class::stopped);
  CHECK(result.seen == "it reads nothing");
  CHECK(result.seen_at == 0);
}

TEST_CASE("The chart has the first series that differ, and their differences") {
  const Cycle bench;
  const Result result = bench.judged(with({{1204, "L_P_B_I_X", 1}, {1500, "L_P_HORN_O_ON", 1}}));
  CHECK(contains(result.chart, R"({"name":"L_P_B_I_X","base":[],"run":[1204000000,1]})"));
  CHECK(contains(result.chart, R"({"name":"L_P_HORN_O_ON","base":[],"run":[1500000000,1]})"));
  CHECK(contains(result.chart, R"("words":"unexpected: on"})"));
  CHECK(bench.judged(kBase).chart == "null");
}

TEST_CASE("A PLC at a link may read at any time, and its times may differ by the window") {
  Bench bench;
  bench.base.in_virtual_time = false;
  bench.base.window = 20 * kMs;
  bench.base.readers.front().period = 0;
  bench.set_base(kBase);
  Sets near = kBase;
  for (Bench::Set& set : near) set.ms += 15;
  CHECK(bench.judged(near).is == Class::no_effect);
  const Result result = bench.judged(with({{2501, "L_P_B_I_X", 1}}));
  CHECK(result.is == Class::undetected);
  CHECK(result.seen == "L_P_B_I_X on");
  CHECK(result.seen_at == 2501 * kMs);
}

}  // namespace
}  // namespace symplant::campaign
