// Why a symbol has its value.
#include "why_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("An event is driven by a state, which its device must reach or leave") {
  const DescribedPlant cell(with_prefix(kCell), "\"name\": \"x\"");
  Asked asked(cell);
  asked.set("AGV_O_P1").to(1000);
  CHECK(asked.why("AGV_I_P2") ==
        "L_P_AGV_I_P2 has been off since the start, PLC input %IX1, event P2 of L_P_AGV (symbols.csv:3)\n"
        "    L_P_AGV has been in P1 since the start: it waits for a command\n"
        "        %QX3 (operation P2, symbols.csv:5) has never been on\n"
        "        %QX2 (operation P1, symbols.csv:4) has been on since 1 s, and leads to P1\n");
}

TEST_CASE("An event of several states, and one that outputs switch, say which") {
  const DescribedPlant plant(
      with_prefix({"CLP_I_CLP1", "CLP_I_UNCLP", "CLP_O_CLP1", "CLP_O_UNCLP", "CLP_I_BUSY", "CLP_I_SAFE"}),
      R"("devices": {"L_P_CLP": {"outputs": {
                                  "CLP1": {"enter": {"BUSY": true, "SAFE": true}, "leave": {"SAFE": false}},
                                  "UNCLP": {"enter": {"BUSY": false}}}}})");
  const Asked asked(plant);
  CHECK(contains(asked.why("CLP_I_SAFE"), " (symbols.csv:7): it is on while L_P_CLP is in CLP1\n"));
  CHECK(contains(asked.why("CLP_I_BUSY"),
                 ": L_P_CLP switches it, entering CLP1 switches it on, entering UNCLP switches it off\n"));
}

TEST_CASE("The symbol of a signal shows its formula, and a number says what formulas read it") {
  std::vector<Row> rows = with_prefix(kCell);
  rows.push_back({"FILL", "", "INT", "0", "%IW3"});
  rows.push_back({"SET", "", "INT", "0", "%QW3"});
  const DescribedPlant cell(rows, R"("values": {"level": {"start": 3}, "twice": {"is": "2 * SET"}},
      "signals": {"FILL": "level + 1"}, "requirements": [{"name": "r", "never": "level > SET"}],
      "devices": {"L_P_MC": {"transitions": [{"from": "IDLE1", "to": "RUN2", "takes": {"seconds": "SET"}}]}})");
  CHECK(contains(Asked(cell).why("FILL"), ": it shows level (3) + 1\n"));
  const std::string why = Asked(cell).why("SET");
  CHECK(contains(why, "value twice reads it\n"));
  CHECK(contains(why, "requirement `r` reads it\n"));
  CHECK(contains(why, "a condition of L_P_MC reads it\n"));
}

TEST_CASE("An operation that a value reads says so") {
  const DescribedPlant cell(with_prefix(kCell), R"("values": {
      "count": {"changes": [{"when": "L_P_MC_O_RUN2", "to": "count + 1"}]},
      "reset": {"changes": [{"when": "count > 3", "to": "0 * L_P_MC_O_RUN2"}]},
      "flow": {"is": "2 * L_P_MC_O_RUN2"}})");
  const std::string why = Asked(cell).why("MC_O_RUN2");
  CHECK(contains(why, "value count reads it\n"));
  CHECK(contains(why, "value reset reads it\n"));
  CHECK(contains(why, "value flow reads it\n"));
}

TEST_CASE("Inverted symbols are explained by their meaning, with the bit in brackets") {
  const DescribedPlant cell(with_prefix(kCell), R"("inverted": ["L_P_AGV_*"], "devices": {"L_P_MC": {"transitions": [
      {"from": "IDLE1", "to": "RUN2", "on": "RUN2", "when": "not L_P_AGV_I_P2"}]}})");
  Asked asked(cell);
  CHECK(contains(asked.why("AGV_I_P1"),
                 "L_P_AGV_I_P1 has been on (bit 0) since the start, PLC input %IX0 (inverted), event P1 of L_P_AGV "
                 "(symbols.csv:2)\n    L_P_AGV has been in P1"));
  asked.set("MC_O_RUN2").to(100);
  CHECK(
      asked.why("MC") ==
      "L_P_MC has been in IDLE1 since the start: %QX6 (operation RUN2, symbols.csv:8) has been on since 0.1 s, but "
      "`when` needs L_P_AGV_I_P2 on (bit 0)\n"
      "    L_P_AGV_I_P2 has been off (bit 1) since the start, PLC input %IX1 (inverted), event P2 of L_P_AGV "
      "(symbols.csv:3)\n"
      "        L_P_AGV has been in P1 since the start: %QX3 (inverted, operation P2, symbols.csv:5) has never been on "
      "(bit 0)\n");
  asked.set("AGV_O_P2", 0).to(200);
  CHECK(contains(asked.why("AGV"), "%QX3 (inverted, operation P2, symbols.csv:5) has been on (bit 0) since 0.2 s"));
  asked.set("AGV_O_P2", 1).to(300).to(2000);
  CHECK(contains(asked.why("AGV_O_P2"), "L_P_AGV_O_P2 has been off (bit 1) since 0.3 s, PLC output %QX3 (inverted), "));
  CHECK(contains(asked.why("AGV"), "before that, %QX3 (inverted, operation P2, symbols.csv:5) was on (bit 0) from "));
  asked.force("AGV_I_P1", 0).to(2000);
  CHECK(contains(asked.why("AGV"), "L_P_AGV_I_P1 is forced to on (bit 0) since 2 s"));
}

TEST_CASE("What outputs switch is said in the meaning of an inverted event") {
  const DescribedPlant plant(with_prefix({"CLP_I_CLP1", "CLP_I_UNCLP", "CLP_O_CLP1", "CLP_O_UNCLP", "CLP_I_SAFE"}),
                             R"("inverted": ["L_P_CLP_I_SAFE"], "devices": {"L_P_CLP": {"outputs": {
                                  "CLP1": {"enter": {"SAFE": true}, "leave": {"SAFE": false}}}}})");
  CHECK(contains(Asked(plant).why("CLP_I_SAFE"), "(symbols.csv:6): it is on (bit 0) while L_P_CLP is in CLP1\n"));
}

TEST_CASE("An event that follows a condition names what that needs, or what makes it hold") {
  std::vector<Row> rows = with_prefix(kCell);
  rows.push_back({"L_PANEL_I_READY", "", "BOOL", "FALSE", "%IX99"});
  const DescribedPlant plant(rows, R"("follow": {"L_PANEL_I_READY": "L_P_AGV.P2 and L_P_MC.IDLE1"})");
  Asked asked(plant);
  CHECK(asked.why("L_PANEL_I_READY") ==
        "L_PANEL_I_READY has been off since the start, PLC input %IX99, symbol L_PANEL_I_READY (symbols.csv:9): it "
        "follows a condition that needs L_P_AGV.P2\n"
        "    L_P_AGV has been in P1 since the start: %QX3 (operation P2, symbols.csv:5) has never been on\n");
  asked.state("AGV", "P2").to(0);
  CHECK(contains(asked.why("L_PANEL_I_READY"), "has been on since the start"));
  CHECK(contains(asked.why("L_PANEL_I_READY"),
                 ": it follows a condition that holds\n    L_P_AGV has been in P2 since the start"));
}

TEST_CASE("An event that no device drives, and a force, are said") {
  std::vector<Row> rows = with_prefix(kCell);
  rows.push_back({"TEMP", "", "INT", "7", "%IW3"});
  const DescribedPlant plant(rows, "\"name\": \"x\"");
  Asked asked(plant);
  CHECK(asked.why("TEMP") ==
        "TEMP has been 7 since the start, PLC input %IW3, symbol TEMP (symbols.csv:9): no device drives it\n");
  asked.to(500).force("AGV_I_P2", 1).to(500);
  CHECK(contains(asked.why("AGV_I_P2"), "L_P_AGV_I_P2 has been on since 0.5 s, forced since 0.5 s, PLC input %IX1, "));
  CHECK(contains(asked.why("AGV"), "\n    L_P_AGV_I_P2 is forced to on since 0.5 s\n"));
}

TEST_CASE("Of two events on one address the one that a device drives is followed") {
  std::vector<Row> rows = with_prefix(kCell);
  rows.push_back({"L_X_COPY_I_Q", "", "BOOL", "FALSE", "%IX1"});
  const DescribedPlant plant(rows, "\"name\": \"x\"");
  CHECK(contains(Asked(plant).why("L_X_COPY_I_Q"), "\n    L_P_AGV has been in P1 since the start: %QX3 (operation P2"));
}

TEST_CASE("An operation names its device, what that waits for, and what else reads it") {
  std::vector<Row> rows = with_prefix(kCell);
  rows.push_back({"LAMP", "", "BOOL", "FALSE", "%QX77"});
  const DescribedPlant cell(
      rows, R"("devices": {"L_P_AGV": {"transitions": [{"from": "P1", "to": "P2", "when": "L_P_MC.RUN2"}]}},
      "requirements": [{"name": "one", "never": "L_P_AGV_O_P2 and L_P_MC_O_RUN2"}])");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(1000);
  CHECK(asked.why("AGV_O_P2") ==
        "L_P_AGV_O_P2 has been on since 1 s, PLC output %QX3, operation P2 of L_P_AGV (symbols.csv:5)\n"
        "    L_P_AGV has been in P1 since the start: %QX3 (operation P2, symbols.csv:5) has been on since 1 s, but "
        "`when` needs L_P_MC.RUN2\n"
        "        L_P_MC has been in IDLE1 since the start: %QX6 (operation RUN2, symbols.csv:8) has never been on\n"
        "    requirement `one` reads it\n");
  CHECK(contains(asked.why("MC_O_RUN2"),
                 "(symbols.csv:8)\n    L_P_MC has been in IDLE1 since the start, and goes to "
                 "RUN2 on it\n    requirement `one` reads it\n"));
  asked.state("MC", "RUN2").set("MC_O_RUN2").to(1000);
  CHECK(
      contains(asked.why("MC_O_RUN2"), "(symbols.csv:8)\n    L_P_MC has been in RUN2 since 1 s, to which it leads\n"));
  CHECK(asked.why("LAMP") ==
        "LAMP has been off since the start, PLC output %QX77, symbol LAMP (symbols.csv:9); no device and no condition "
        "uses it\n");
}

TEST_CASE("A disarmed operation is without effect") {
  const DescribedPlant plant(with_prefix({"MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2"}), R"("devices": {"L_P_MC": {
      "transitions": [{"from": "RUN2", "to": "IDLE1", "automatic": true, "after": "1s"}]}})");
  Asked asked(plant);
  asked.set("MC_O_RUN2").to(0).to(1000).to(2000);
  CHECK(contains(asked.why("MC_O_RUN2"), "(symbols.csv:4), without effect until it goes off and on again\n"));
}

}  // namespace
}  // namespace symplant::test
