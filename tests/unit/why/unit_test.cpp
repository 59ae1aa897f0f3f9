// Why a settled device stays where it is.
#include "why_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A device whose `when` does not hold names what it needs, and why that is not so") {
  const DescribedPlant cell(with_prefix(kCell), R"("devices": {"L_P_MC": {"transitions": [
      {"from": "IDLE1", "to": "RUN2", "when": "L_P_AGV.P2", "takes": "1s"}]}})");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(1000).to(2000).set("AGV_O_P2", 0).set("AGV_O_P1").to(3000).to(4000);
  asked.set("MC_O_RUN2").to(13'000);
  CHECK(asked.why("MC") ==
        "L_P_MC has been in IDLE1 since the start: %QX6 (operation RUN2, symbols.csv:8) has been on since 13 s, but "
        "`when` needs L_P_AGV.P2\n"
        "    L_P_AGV has been in P1 since 4 s: it waits for a command\n"
        "        %QX3 (operation P2, symbols.csv:5) has been off since 3 s\n"
        "        %QX2 (operation P1, symbols.csv:4) has been on since 3 s, and leads to P1\n");
  asked.set("AGV_O_P1", 0).to(14'000);
  CHECK(contains(asked.why("MC"),
                 "\n    L_P_AGV has been in P1 since 4 s: %QX3 (operation P2, symbols.csv:5) has been "
                 "off since 3 s\n"));
}

TEST_CASE("A device without a command names the operations that would move it") {
  const DescribedPlant plant(with_prefix({"ROB_I_HOME", "ROB_I_JOB1", "ROB_O_JOB1", "ROB_O_JOB2", "ROB_O_HOME"}),
                             "\"name\": \"x\"");
  Asked asked(plant);
  CHECK(asked.why("ROB") ==
        "L_P_ROB has been in JOB1 since the start: it waits for a command\n"
        "    %QX3 (operation JOB2, symbols.csv:5) has never been on\n"
        "    %QX4 (operation HOME, symbols.csv:6) has never been on\n");
}

TEST_CASE("A command that starts nothing is named") {
  const DescribedPlant plant(with_prefix({"AGV_I_P1", "AGV_I_P2", "AGV_I_P3", "AGV_O_P2", "AGV_O_P3"}),
                             R"("devices": {"L_P_AGV": {"only": true, "transitions": [
      {"from": "P1", "to": "P2", "takes": "1s"}, {"from": "P2", "to": "P3", "takes": "1s"}]}})");
  Asked asked(plant);
  asked.set("AGV_O_P3").to(1000);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1 since the start: %QX4 (operation P3, symbols.csv:6) has been on since 1 s, but no "
        "transition on it starts from P1\n");
  asked.state("AGV", "P3").to(1000);
  CHECK(
      asked.why("AGV") ==
      "L_P_AGV has been in P3 since 1 s: %QX4 (operation P3, symbols.csv:6) has been on since 1 s, and leads to P3\n");
  asked.set("AGV_O_P3", 0).to(2000);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P3 since 1 s: no transition leads from there\n"
        "    before that, %QX4 (operation P3, symbols.csv:6) was on from 1 s to 2 s\n");
}

TEST_CASE("An automatic transition and a command that must hold for a time name the time left") {
  const DescribedPlant plant(with_prefix({"MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2"}),
                             R"("devices": {"L_P_MC": {"only": true,
      "transitions": [{"from": "IDLE1", "to": "RUN2", "after": "700ms", "takes": "1s"},
                      {"from": "RUN2", "to": "IDLE1", "automatic": true, "after": "5s"}]}})");
  Asked asked(plant);
  asked.set("MC_O_RUN2").to(1000).to(1500);
  CHECK(asked.why("MC") ==
        "L_P_MC has been in IDLE1 since the start: %QX2 (operation RUN2, symbols.csv:4) has been on since 1 s, and has "
        "an effect in 0.2 s\n");
  CHECK(contains(asked.why("MC", false), "has been on since 1 s, and has an effect after 0.7 s\n"));
  asked.to(1700).to(2700).set("MC_O_RUN2", 0).to(3000);
  CHECK(asked.why("MC") ==
        "L_P_MC has been in RUN2 since 2.7 s: it goes to IDLE1 without a command in 4.7 s\n"
        "    before that, %QX2 (operation RUN2, symbols.csv:4) was on from 1 s to 3 s\n");
  CHECK(contains(asked.why("MC", false), "it goes to IDLE1 without a command after 5 s\n"));
}

TEST_CASE("A command that has had its effect must go off first, also where the plant is not at hand") {
  const DescribedPlant plant(with_prefix({"MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2"}), R"("devices": {"L_P_MC": {
      "transitions": [{"from": "RUN2", "to": "IDLE1", "automatic": true, "after": "1s"}]}})");
  Asked asked(plant);
  asked.set("MC_O_RUN2").to(0).to(1000).to(2000).to(3000);
  const std::string expected =
      "L_P_MC has been in IDLE1 since 2 s: %QX2 (operation RUN2, symbols.csv:4) has been on since the start, but has "
      "no "
      "effect until it goes off and on again\n";
  CHECK(asked.why("MC") == expected);
  CHECK(asked.why("MC", false) == expected);
}

TEST_CASE("Commands to several states are a conflict") {
  const DescribedPlant cell(with_prefix(kCell), "\"name\": \"x\"");
  Asked asked(cell);
  asked.set("AGV_O_P1").set("AGV_O_P2").to(1000);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1 since the start: it has commands to several states at once and obeys none of them, "
        "%QX2 (operation P1, symbols.csv:4) has been on since 1 s, %QX3 (operation P2, symbols.csv:5) has been on "
        "since 1 s\n");
}

TEST_CASE("A disabled device names what disables it, and why that is there") {
  const DescribedPlant cell(with_prefix(kCell), R"("devices": {"L_P_MC": {"disables": {"RUN2": ["L_P_AGV"]}}})");
  Asked asked(cell);
  asked.set("MC_O_RUN2").to(0).to(1000);
  CHECK(contains(asked.why("AGV"), "disabled by L_P_MC in RUN2 since 1 s, none of its operations has been on\n"));
  asked.set("MC_O_RUN2", 0).set("AGV_O_P2").to(1200);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1, disabled by L_P_MC in RUN2 since 1 s, %QX3 (operation P2, symbols.csv:5) has been on "
        "since 1.2 s\n"
        "    L_P_MC has been in RUN2 since 1 s: it goes to IDLE1 without a command in 0.8 s\n");
}

TEST_CASE("A device in an instantaneous loop is frozen") {
  const DescribedPlant plant(with_prefix({"A_I_P1", "A_I_P2"}), R"("devices": {"L_P_A": {"transitions": [
      {"from": "P1", "to": "P2", "automatic": true}, {"from": "P2", "to": "P1", "automatic": true}]}})");
  CHECK(contains(Asked(plant).why("A"),
                 ", frozen since the start: it is in an instantaneous loop, and stays frozen "
                 "until the run ends\n"));
}

TEST_CASE("A state that is several transitions away is reached through the next one") {
  const DescribedPlant plant(
      with_prefix({"T_I_A1", "T_I_B2", "T_I_C3", "T_O_B2", "T_O_C3", "GATE_I_SHUT", "GATE_O_OPEN"}),
      R"("devices": {"L_P_T": {"sequence": "neighbours"},
                                "L_P_GATE": {"transitions": [{"from": "SHUT", "to": "OPEN", "when": "L_P_T.C3"}]}})");
  Asked asked(plant);
  asked.set("GATE_O_OPEN").to(1000);
  CHECK(contains(asked.why("GATE"),
                 "but `when` needs L_P_T.C3\n"
                 "    L_P_T has been in A1 since the start, and goes to C3 through B2: %QX3 "
                 "(operation B2, symbols.csv:5) has never been on\n"));
}

TEST_CASE("Only the transitions toward the state in question are named") {
  const DescribedPlant plant(
      with_prefix({"T_I_A1", "T_I_B2", "T_I_C3", "T_I_D4", "T_O_B2", "T_O_C3", "T_O_D4", "GATE_I_SHUT", "GATE_O_OPEN"}),
      R"("devices": {"L_P_T": {"only": true, "transitions": [{"from": "A1", "to": "B2"}, {"from": "A1", "to": "D4"},
                                                             {"from": "D4", "to": "A1", "automatic": true, "after": "1s"},
                                                             {"from": "B2", "to": "C3"}]},
                     "L_P_GATE": {"transitions": [{"from": "SHUT", "to": "OPEN", "when": "L_P_T.C3"}]}})");
  Asked asked(plant);
  asked.set("GATE_O_OPEN").to(1000);
  CHECK(contains(asked.why("GATE"),
                 "\n    L_P_T has been in A1 since the start, and goes to C3 through B2: %QX4 "
                 "(operation B2, symbols.csv:6) has never been on\n"));
  CHECK(contains(asked.why("T_I_D4"),
                 "\n    L_P_T has been in A1 since the start: %QX6 (operation D4, symbols.csv:8) "
                 "has never been on\n"));
}

TEST_CASE("A command that must hold for a time does not conflict before") {
  const DescribedPlant plant(with_prefix({"MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2", "MC_O_IDLE1"}),
                             R"("devices": {"L_P_MC": {
      "transitions": [{"from": "IDLE1", "to": "RUN2", "after": "700ms"}]}})");
  Asked asked(plant);
  asked.set("MC_O_RUN2").set("MC_O_IDLE1").to(0).to(500);
  CHECK(contains(asked.why("MC"),
                 "%QX2 (operation RUN2, symbols.csv:4) has been on since the start, and has an effect "
                 "in 0.2 s\n"));
  asked.to(700);
  CHECK(contains(asked.why("MC"), "obeys none of them, %QX2 (operation RUN2"));
}

TEST_CASE("A state to which no transition leads is named") {
  const DescribedPlant plant(
      with_prefix({"T_I_A1", "T_I_B2", "GATE_I_SHUT", "GATE_O_OPEN"}),
      R"("devices": {"L_P_GATE": {"transitions": [{"from": "SHUT", "to": "OPEN", "when": "L_P_T.B2"}]}})");
  Asked asked(plant);
  asked.set("GATE_O_OPEN").to(1000);
  CHECK(contains(asked.why("GATE"),
                 "\n    L_P_T has been in A1 since the start: no transition leads from there to B2\n"));
  CHECK(asked.why("T") == "L_P_T has been in A1 since the start: no operation and no automatic transition moves it\n");
}

}  // namespace
}  // namespace symplant::test
