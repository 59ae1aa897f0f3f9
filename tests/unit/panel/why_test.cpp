// The panel explains as `--why` does at the end of the run.
#include "support/malfunction_bench.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

using exec::LinkState;

/// A situation, the name that is asked for, and a part of the answer.
struct Situation {
  std::string acts;
  std::string name;
  std::string part;
  std::optional<LinkState> link = {};
  bool freezes = false;
  std::string scenario = {};
};

PanelPlan plan_of(const Situation& situation) {
  PanelPlan plan;
  plan.reported = with_malfunctions(R"({"name":"jam","of":"L_P_AGV","stuck":true},
                                       {"name":"wire","force":{"L_P_EYE_I_ON":true}},
                                       {"name":"cable","lose":true})");
  plan.reported.disables("DOOR", "OPEN2", "AGV");
  plan.reported.description.requirements.push_back({"still", "L_P_AGV.P2", "", "", 0});
  plan.link = situation.link;
  plan.freezes = situation.freezes;
  plan.scenario = situation.scenario;
  return plan;
}

TEST_CASE("The panel and the end of the run give the same explanation") {
  const Situation situation = GENERATE(values<Situation>({
      {"", "L_P_AGV", "(no link and no scenario writes it)"},
      {"",
       "L_P_AGV_O_P1",
       "no step of the scenario sets it\n",
       {},
       false,
       R"({"at":"1 h","set":{"L_P_AGV_O_P2":true}})"},
      {"", "L_P_AGV_O_P2", "its link set: still waits for its PLC", LinkState::waiting},
      {"", "L_P_AGV_O_P2", "its link set: is lost\n", LinkState::lost},
      {"", "L_P_AGV", "(its link set: is lost)", LinkState::lost},
      {"", "L_P_AGV", "the plant is frozen, since link set: is lost\n", LinkState::lost, true},
      {"", "L_P_AGV", "the plant is frozen, since link set: still waits for its PLC\n", LinkState::waiting, true},
      {"", "L_P_AGV", "has never been on\n", LinkState::live, true},
      {R"({"start":"cable"})", "L_P_AGV_O_P2", "its link set: is lost, cut by malfunction `cable`", LinkState::lost},
      {R"({"freeze":true})", "L_P_AGV", "the plant is frozen at the panel\n"},
      {R"({"start":"jam"})", "L_P_AGV", "disabled by malfunction `jam` since"},
      {R"({"start":"wire"})", "L_P_EYE_I_ON", "forced by malfunction `wire`"},
      {R"({"force":{"L_P_AGV_I_P1":false}})", "L_P_AGV", "L_P_AGV_I_P1 is forced to off since"},
      {R"({"state":{"L_P_DOOR":"OPEN2"}})", "L_P_AGV", "disabled by L_P_DOOR in OPEN2 since"},
      {R"({"set":{"L_P_AGV_O_P2":true,"L_P_AGV_O_P1":true}})", "L_P_AGV", "commands to several states at once"},
      {R"({"state":{"L_P_AGV":"P2"}})", "still", "is violated: its condition must never hold"},
  }));
  CAPTURE(situation.acts, situation.name, situation.part);
  PanelBench bench(plan_of(situation));
  if (!situation.acts.empty()) bench.act(situation.acts);
  const std::string text = bench.why(situation.name);
  CHECK(contains(text, situation.part));
  CHECK(bench.why_at_the_end(situation.name) == text);
}

TEST_CASE("An exercise that the panel plays counts at the end, too") {
  PanelPlan plan;
  const TemporaryFolder folder;
  plan.exercise_files = {folder.write(
      "drive.json",
      R"({"symplant-scenario":1,"exercise":{"title":"Drive"},"steps":[{"at":"1 h","set":{"L_P_AGV_O_P2":true}}]})")};
  PanelBench bench(plan);
  bench.act(R"({"exercise":"drive"})");
  const std::string text = bench.why("L_P_AGV_O_P1");
  CHECK(contains(text, "no step of the scenario sets it"));
  CHECK(bench.why_at_the_end("L_P_AGV_O_P1") == text);
}

}  // namespace
}  // namespace symplant::test
