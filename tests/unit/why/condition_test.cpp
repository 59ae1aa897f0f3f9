// Which parts of a condition are named.
#include "why_support.hpp"

namespace symplant::test {
namespace {

/// What the gate needs, with `when` as its condition.
std::string need(const std::string& when, const std::vector<std::string>& on = {}) {
  std::vector<Row> rows = with_prefix({"GATE_I_SHUT", "GATE_O_OPEN"});
  for (const char* name : {"A", "B", "C", "D", "E", "F", "G", "H", "K", "L"}) {
    rows.push_back({name, "", "BOOL", "FALSE", "%QX" + std::to_string(50 + name[0] - 'A')});
  }
  rows.push_back({"N", "", "INT", "0", "%QW9"});
  rows.push_back({"R", "", "REAL", "0.0", "%QD20"});
  const DescribedPlant plant(
      rows, R"("devices": {"L_P_GATE": {"transitions": [{"from": "SHUT", "to": "OPEN", "when": ")" + when + R"("}]}})");
  Asked asked(plant);
  for (const std::string& name : on) asked.set(name);
  asked.set("GATE_O_OPEN").to(1000);
  const std::string text = asked.why("GATE");
  const std::size_t begin = text.find("`when` ");
  return begin == text.npos ? text : text.substr(begin + 7, text.find('\n') - begin - 7);
}

TEST_CASE("Of a conjunction the false parts are named, of a disjunction all") {
  CHECK(need("A and B and not C") == "needs A and B");
  CHECK(need("A and B and not C", {"A", "C"}) == "needs B and not C");
  CHECK(need("A or B") == "needs A or B");
  CHECK(need("(A or B) and C", {"C"}) == "needs A or B");
  CHECK(need("(A or B) and C") == "needs (A and C) or (B and C)");
  CHECK(need("(A and B) or C", {"A"}) == "needs B or C");
}

TEST_CASE("Numbers are compared as in the description") {
  CHECK(need("N > 5") == "needs N > 5");
  CHECK(need("R >= 2.5 and N < 3") == "needs R >= 2.5");
}

TEST_CASE("A large condition is read through its network") {
  CHECK(need("A and B and C and D and E and F and G and H", {"B", "D", "E", "F", "G"}) == "needs A and C and H");
  CHECK(need("A or B or C or D or E or F or G or H or K or L") == "needs A or B or C or D or E or F or G or H or more");
  CHECK(need("(A or B or C or D or E or F or G) and H", {"H"}) == "needs A or B or C or D or E or F or G");
}

TEST_CASE("A condition that nothing can make true is said to be so") { CHECK(need("N > 100000") == "can never hold"); }

TEST_CASE("Each part is explained once") {
  const DescribedPlant cell(with_prefix(kCell), R"("devices": {"L_P_MC": {"transitions": [
      {"from": "IDLE1", "to": "RUN2", "when": "L_P_AGV.P2 and not L_P_AGV_I_P1", "takes": "1s"}]}})");
  Asked asked(cell);
  asked.set("MC_O_RUN2").to(1000);
  CHECK(asked.why("MC") ==
        "L_P_MC has been in IDLE1 since the start: %QX6 (operation RUN2, symbols.csv:8) has been on since 1 s, but "
        "`when` needs L_P_AGV.P2 and not L_P_AGV_I_P1\n"
        "    L_P_AGV has been in P1 since the start: %QX3 (operation P2, symbols.csv:5) has never been on\n"
        "    L_P_AGV_I_P1 has been on since the start, PLC input %IX0, event P1 of L_P_AGV (symbols.csv:2)\n"
        "        L_P_AGV has been in P1 since the start, see above\n");
}

}  // namespace
}  // namespace symplant::test
