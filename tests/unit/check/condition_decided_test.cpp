// Whether conditions can hold and fail.
#include "check_support.hpp"

namespace symplant::test {
namespace {

/// What SP614 reports of a condition.
struct Verdict {
  bool never;
  bool always;
};

Verdict verdict_in(const std::vector<Row>& rows, const std::string& when) {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", when)};
  const Analysed list = analyse_described(rows, describing({d}));
  REQUIRE(list.evidence().faults.empty());
  const std::string found = reported(list, "condition-decided");
  return {found.find("can never hold: correct it") != found.npos, found.find("always holds: correct it") != found.npos};
}

Verdict verdict(const std::string& when) { return verdict_in(two_devices(), when); }
bool never(const std::string& when) { return verdict(when).never; }
bool always(const std::string& when) { return verdict(when).always; }
bool open(const std::string& when) {
  const Verdict v = verdict(when);
  return !v.never && !v.always;
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

TEST_CASE("A comparison of a number may hold and fail, whatever others do") {
  CHECK(never("L_P_E_I_SPEED < 3 and not L_P_E_I_SPEED < 3"));
  CHECK(always("L_P_E_I_SPEED < 3 or not L_P_E_I_SPEED < 3"));
  CHECK(open("L_P_E_I_SPEED < 3 and L_P_E_I_SPEED > 5"));
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

Verdict of_many(const std::string& when) { return verdict_in(many_bits(), when); }

std::string all_bits(const std::string& between, const std::string& before) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += (i == 0 ? "" : between) + before + "L_P_B_I_X" + std::to_string(i);
  return text;
}

TEST_CASE("Many parts are examined, whether or not they depend on each other") {
  CHECK(of_many(all_bits(" and ", "") + " and L_P_D.P1 and L_P_D.P2").never);
  CHECK(of_many(all_bits(" or ", "") + " or L_P_D.P1 or not L_P_D.P1").always);
  const std::string up = "(" + all_bits(" or ", "") + ")";
  const std::string down = "(" + all_bits(" or ", "not ") + ")";
  CHECK(of_many(up + " and " + down + " and L_P_B_I_X3 and not L_P_B_I_X3").never);
  CHECK(of_many(up + " and (L_P_D.P1 and L_P_D.P2) and " + down).never);
  for (const std::string& text : {all_bits(" and ", ""), up + " and " + down}) {
    CHECK_FALSE(of_many(text).never);
    CHECK_FALSE(of_many(text).always);
  }
}

TEST_CASE("A condition that takes too many steps counts as open") {
  // Each pair has an odd number of true bits, and all pairs together form a circle of odd length: it can never hold.
  std::string text;
  for (int i = 0; i < 39; ++i) {
    const std::string a = "L_P_B_I_X" + std::to_string(i);
    const std::string b = "L_P_B_I_X" + std::to_string((i * 7 + 1) % 39);
    const std::string c = "L_P_B_I_X" + std::to_string((i * 11 + 5) % 39);
    text += (i == 0 ? "(" : " and (") + a + " or " + b + " or " + c + ") and (not " + a + " or not " + b + " or not " +
            c + ")";
  }
  CHECK_FALSE(of_many(text).always);
  CHECK_FALSE(of_many(text).never);
}

}  // namespace
}  // namespace symplant::test
