// Steps of scenarios in words.
#include "symplant/scenario/step_words.hpp"

#include "scenario_support.hpp"
#include "support/described_plant.hpp"

namespace symplant::test {
namespace {

/// The words of the step with these members.
std::string words_of(const std::string& members) {
  static const DescribedPlant plant(bits({"L_P_AGV_I_P1", "L_P_AGV_I_P2", "L_P_AGV_O_P1", "L_P_AGV_O_P2",
                                          "L_P_BTN_I_START", "L_P_GATE_I_SHUT", "L_P_EYE_I_PART"}),
                                    R"("inverted": ["L_P_GATE_I_SHUT"],
    "material": { "kinds": { "raw": { "length": "200 mm" } },
                  "tracks": { "CV1": { "length": "3 m", "drives": [{ "forward": "L_P_AGV.P1", "speed": "0.5 m/s" }] } },
                  "places": { "FIXTURE": {} } },
    "malfunctions": [{ "name": "eye blind", "force": { "L_P_EYE_I_PART": false } }],
    "values": { "leak": { "start": 0, "min": 0 } })");
  static const trace::PlantNames names(plant.rows);
  const std::string text = scenario_text("{\"at\":\"1s\"," + members + "}");
  const auto read = scenario::read_scenario(text, names, {});
  INFO((read.faults.empty() ? "" : faults_text(text, read.faults.front().faults)));
  REQUIRE(read.scenario);
  return scenario::actions_words(read.scenario->steps.front(), names);
}

TEST_CASE("Each action of a step has words") {
  CHECK(words_of(R"("set":{"L_P_BTN_I_START":true})") == "set L_P_BTN_I_START on");
  CHECK(words_of(R"("set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":false})") == "set L_P_AGV_O_P1 on, L_P_AGV_O_P2 off");
  CHECK(words_of(R"("set":{"leak":80.5})") == "set leak 80.5");
  CHECK(words_of(R"("state":{"L_P_AGV":"P2"})") == "put L_P_AGV into P2");
  CHECK(words_of(R"("put":{"at":"CV1@300 mm","kind":"raw"})") == "put `raw` on CV1 at 300 mm");
  CHECK(words_of(R"("put":{"at":"CV1@1.5 m","kind":"raw"})") == "put `raw` on CV1 at 1.5 m");
  CHECK(words_of(R"("put":{"at":"FIXTURE","kind":"raw"})") == "put `raw` at FIXTURE");
  CHECK(words_of(R"("take":"FIXTURE")") == "take a part from FIXTURE");
  CHECK(words_of(R"("take":["CV1@0 mm","CV1"])") == "take a part from CV1 at 0 mm, CV1");
  CHECK(words_of(R"("force":{"L_P_AGV_I_P2":false})") == "force L_P_AGV_I_P2 off");
  CHECK(words_of(R"("release":["L_P_AGV_I_P1","L_P_AGV_I_P2"])") == "release L_P_AGV_I_P1, L_P_AGV_I_P2");
  CHECK(words_of(R"("start":"eye blind")") == "start malfunction `eye blind`");
  CHECK(words_of(R"("stop":["eye blind","L_P_AGV stuck"])") == "stop malfunctions `eye blind`, `L_P_AGV stuck`");
}

TEST_CASE("The words of an inverted symbol have its meaning and its bit") {
  CHECK(words_of(R"("force":{"L_P_GATE_I_SHUT":false})") == "force L_P_GATE_I_SHUT on (bit 0)");
}

TEST_CASE("Several actions of a step are joined in the order in which they are done") {
  CHECK(words_of(R"("start":"eye blind","force":{"L_P_AGV_I_P1":true},"set":{"L_P_BTN_I_START":true,"leak":3})") ==
        "set L_P_BTN_I_START on, leak 3, force L_P_AGV_I_P1 on, start malfunction `eye blind`");
}

TEST_CASE("A step without actions has no words") { CHECK(words_of(R"("text":"Look at the line")").empty()); }

TEST_CASE("A step that restarts a program names its controller") {
  const BenchTables tables(kAgv);
  const trace::PlantNames names(tables.rows);
  scenario::Step step;
  step.restart = {0};
  CHECK(scenario::actions_words(step, names) == "restart the program");
}

}  // namespace
}  // namespace symplant::test
