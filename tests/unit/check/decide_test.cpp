// Whether conditions can hold and fail.
#include "check/reachability/decide.hpp"

#include "check_support.hpp"

namespace symplant::test {
namespace {

using check::Answer;
using check::Verdict;

Verdict verdict(const std::string& when) {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", when)};
  const Analysed list = analyse_described(two_devices(), describing({d}));
  REQUIRE(list.evidence().faults.empty());
  return check::decide(list.model().units[0].conditions[0], list.model(), check::AllStates(list.model()));
}

bool never(const std::string& when) { return verdict(when).never(); }
bool always(const std::string& when) { return verdict(when).always(); }
bool open(const std::string& when) {
  const Verdict v = verdict(when);
  return v.holds == Answer::yes && v.fails == Answer::yes;
}

TEST_CASE("A device is in one state at most, and not moving at the same time") {
  CHECK(never("L_P_E.A1 and L_P_E.A2"));
  CHECK(never("L_P_E.A1 and L_P_E.moving"));
  CHECK(always("not L_P_E.A1 or not L_P_E.A2"));
  CHECK(always("L_P_E.A1 or L_P_E.A2 or L_P_E.moving"));
  CHECK(open("L_P_E.A1 or L_P_E.A2"));
  CHECK(open("L_P_E.A1 and L_P_D.P1"));
  CHECK(open("L_P_E.A1"));
}

TEST_CASE("A device that cannot move is never moving") {
  CHECK(never("L_P_B.moving"));
  CHECK(always("L_P_B.ON or L_P_B.NOT_ON"));
}

TEST_CASE("A number is on one side of a bound, and no integer lies between two neighbors") {
  CHECK(never("L_P_E_I_SPEED < 3 and L_P_E_I_SPEED > 5"));
  CHECK(never("L_P_E_I_SPEED > 3 and L_P_E_I_SPEED < 4"));
  CHECK(open("L_P_E_I_SPEED > 3 and L_P_E_I_SPEED < 5"));
  CHECK(always("L_P_E_I_SPEED < 3 or L_P_E_I_SPEED >= 3"));
  CHECK(never("L_P_E_I_SPEED = 3 and L_P_E_I_SPEED = 4"));
  CHECK(always("not (L_P_E_I_SPEED > -2) or L_P_E_I_SPEED >= -1"));
}

TEST_CASE("Between two REALs there is always another, and a REAL may be NaN") {
  CHECK(open("L_P_E_I_LEVEL > 3 and L_P_E_I_LEVEL < 4"));
  CHECK(never("L_P_E_I_LEVEL < 3 and L_P_E_I_LEVEL > 3.5"));
  CHECK(open("L_P_E_I_LEVEL < 3 or L_P_E_I_LEVEL >= 3"));
}

TEST_CASE("A part and its negation contradict anywhere in the condition") {
  CHECK(never("L_P_B_I_ON and (L_P_D.P1 or L_P_E.A1) and not L_P_B_I_ON"));
  CHECK(always("L_P_B_I_ON or (L_P_D.P1 and L_P_E.A1) or not L_P_B_I_ON"));
  CHECK(never("L_P_D.P1 and (L_P_E.A1 and L_P_E.A2)"));
  CHECK(never("not (L_P_B_I_ON or not L_P_B_I_ON)"));
}

std::vector<Row> many_bits() {
  std::vector<std::string> names{"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2", "L_P_D_I_P2"};
  for (int i = 0; i < 40; ++i) names.push_back("L_P_B_I_X" + std::to_string(i));
  return bits(names);
}

Verdict of_many(const std::string& when) {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", when)};
  const Analysed list = analyse_described(many_bits(), describing({d}));
  REQUIRE(list.evidence().faults.empty());
  return check::decide(list.model().units[0].conditions[0], list.model(), check::AllStates(list.model()));
}

std::string all_bits(const std::string& between, const std::string& before) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += (i == 0 ? "" : between) + before + "L_P_B_I_X" + std::to_string(i);
  return text;
}

TEST_CASE("Independent parts are examined in any number") {
  CHECK(of_many(all_bits(" and ", "") + " and L_P_D.P1 and L_P_D.P2").never());
  CHECK(of_many(all_bits(" or ", "") + " or L_P_D.P1 or not L_P_D.P1").always());
  CHECK(of_many(all_bits(" and ", "")).known());
}

TEST_CASE("Too many dependent parts are not examined, unless a few of them decide") {
  const std::string up = "(" + all_bits(" or ", "") + ")";
  const std::string down = "(" + all_bits(" or ", "not ") + ")";
  CHECK_FALSE(of_many(up + " and " + down).known());
  CHECK(of_many(up + " and " + down + " and L_P_B_I_X3 and not L_P_B_I_X3").never());
  CHECK(of_many(up + " and (L_P_D.P1 and L_P_D.P2) and " + down).never());
}

TEST_CASE("A condition of 2,000 parts is examined, a longer one is undecided") {
  const auto of = [](int parts) {
    std::string text;
    for (int i = 0; i < parts; ++i) text += (i == 0 ? "L_P_E_I_SPEED = " : " and L_P_E_I_SPEED = ") + std::to_string(i);
    return verdict(text);
  };
  CHECK(of(2'000).never());
  CHECK_FALSE(of(2'001).known());
}

}  // namespace
}  // namespace symplant::test
