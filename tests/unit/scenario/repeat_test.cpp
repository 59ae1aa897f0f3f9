// Repeats and includes of scenarios.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

/// One turn of the vehicle: 2.2 s.
const std::string kTurn =
    R"({"plus":"100ms","set":{"L_P_AGV_O_P1":false,"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"},
       {"plus":"100ms","set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}},{"wait":"L_P_AGV.P1"})";

std::string repeated(int turns, const std::string& steps) {
  return "{\"repeat\":" + std::to_string(turns) + ",\"steps\":[" + steps + "]}";
}

std::string faults_in_files(const std::string& text, const Play::Files& files = {}) {
  static const BenchTables tables(kAgv);
  const trace::PlantNames names(tables.rows);
  const auto read = scenario::read_scenario(text, names, {}, [&](const std::string& path) -> scenario::OpenedFile {
    const auto found = files.find(path);
    if (found == files.end()) return {std::nullopt, "No such file or directory"};
    return {found->second, ""};
  });
  CHECK(read.scenario.has_value() == read.faults.empty());
  std::string all;
  for (const scenario::FileFaults& file : read.faults) {
    all += file.path + "\n" + faults_text(file.path.empty() ? text : file.text, file.faults);
  }
  return all;
}

TEST_CASE("A repeat does its steps as often as it says") {
  const BenchTables tables(kAgv);
  const Play once(tables, kTurn + "," + kTurn + "," + kTurn + "," + R"({"plus":"1s","expect":"L_P_AGV.P1"})");
  const Play play(tables, repeated(3, kTurn) + "," + R"({"plus":"1s","expect":"L_P_AGV.P1"})");
  CHECK(play.changes() == once.changes());
  CHECK(play.outcomes() == "dhdhh");
  CHECK(play.time_of(3) == 6600);
  CHECK(play.verdict().held == 7);
  CHECK(play.verdict().failed + play.verdict().unreached == 0);
}

TEST_CASE("Repeats nest, and the turn of a failed step is reported") {
  const BenchTables tables(kAgv);
  const std::string inner = repeated(2, R"({"plus":"1s","expect":"L_P_AGV.P1"})");
  const Play play(tables, repeated(3, R"({"plus":"1s"},)" + inner + "," + R"({"plus":"0s","state":{"L_P_AGV":"P2"}})"));
  CHECK(play.outcomes() == "dfd");
  CHECK(play.verdict().held == 2);
  CHECK(play.verdict().failed == 4);
  CHECK(play.failures().starts_with("expected `L_P_AGV.P1` at 5 s, in turn 2 of 3, turn 1 of 2; L_P_AGV has been"));
}

TEST_CASE("Turns that the run does not reach have failed") {
  const BenchTables tables(kAgv);
  const Play play(tables, repeated(10, R"({"plus":"1s","expect":"L_P_AGV.P1"})"), 3500 * kMs);
  CHECK(play.outcomes() == "u");
  CHECK(play.verdict().held == 3);
  CHECK(play.verdict().unreached == 7);
}

TEST_CASE("A force of a later step of the turn before is named") {
  const BenchTables tables(kAgv);
  const Play play(tables, repeated(2,
                                   "{\"plus\":\"1s\",\"expect\":{\"L_P_AGV_I_P1\":true}},\n"
                                   "{\"plus\":\"1s\",\"force\":{\"L_P_AGV_I_P1\":false}}"));
  CHECK(play.failures().find("forced in line 2") != std::string::npos);
}

TEST_CASE("A million turns take the memory of one") {
  const BenchTables tables(kAgv);
  const Play play(tables,
                  repeated(1000, repeated(1000, R"({"plus":"1us"})")) + R"(,{"plus":"0s","expect":"L_P_AGV.P1"})");
  CHECK(play.outcomes() == "dh");
  CHECK(play.time_of(1) == 1000);
}

TEST_CASE("An include does the steps of its file, also in a repeat, relative to the file that includes it") {
  const BenchTables tables(kAgv);
  const Play::Files files = {
      {"parts/turn.json",
       scenario_text(
           R"({"include":"../go.json"},{"plus":"100ms","set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}},{"wait":"L_P_AGV.P1"})")},
      {"go.json",
       scenario_text(R"({"plus":"100ms","set":{"L_P_AGV_O_P1":false,"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"})")}};
  const Play once(tables, kTurn + "," + kTurn);
  const Play play(tables, repeated(2, R"({"include":"parts/turn.json"})"), tables::kNever, 0, files);
  CHECK(play.changes() == once.changes());
  CHECK(play.outcomes() == "dhdh");
}

TEST_CASE("A failure in an included file names it") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"include":"part.json"})", tables::kNever, 0,
                  {{"part.json",
                    "{\"symplant-scenario\":1,\"steps\":[\n{\"at\":\"1s\",\"force\":{\"L_P_AGV_I_P1\":false}},\n"
                    "{\"plus\":\"1s\",\"expect\":{\"L_P_AGV_I_P1\":true}}]}"}});
  CHECK(play.failures().find("forced in line 2 of part.json") != std::string::npos);
}

TEST_CASE("Faults of repeats") {
  CHECK(faults_in_files(scenario_text(repeated(2, R"({"at":"1s"})"))) ==
        "\n1:55 `\"at\"` `at` is not allowed in a repeat; write `plus`\n");
  CHECK(faults_in_files(scenario_text(R"({"repeat":2,"steps":[],"plus":"1s"})"))
            .find("`plus` is not allowed next to `repeat`") != std::string::npos);
  CHECK(faults_in_files(scenario_text(R"({"repeat":2})")).find("add `steps`") != std::string::npos);
  CHECK(faults_in_files(scenario_text(repeated(0, ""))) != "");
  CHECK(faults_in_files(scenario_text(repeated(1'000'001, ""))) != "");
  std::string nested = R"({"plus":"1s"})";
  for (int i = 0; i < 8; ++i) nested = repeated(1, nested);
  CHECK(faults_in_files(scenario_text(nested)) == "");
  CHECK(faults_in_files(scenario_text(repeated(1, nested))).find("nest at most 8") != std::string::npos);
  CHECK(faults_in_files(scenario_text(repeated(10, R"({"plus":"1s"})") + R"(,{"at":"9s"})")).find("at") !=
        std::string::npos);
  CHECK(faults_in_files(scenario_text(repeated(10, R"({"plus":"1s"})") + R"(,{"at":"10s"})")) == "");
}

TEST_CASE("Faults of includes are at the include or in its file") {
  CHECK(faults_in_files(scenario_text(R"({"include":"none.json"})")) ==
        "\n1:44 `\"none.json\"` cannot read `none.json`: No such file or directory\n");
  const Play::Files files = {{"a.json", scenario_text(R"({"include":"b.json"})")},
                             {"b.json", scenario_text(R"({"include":"a.json"})")},
                             {"bad.json", scenario_text(R"({"plus":"1 parsec"})")},
                             {"broken.json", "{"}};
  CHECK(faults_in_files(scenario_text(R"({"include":"a.json"})"), files) ==
        "b.json\n1:44 `\"a.json\"` `a.json` includes itself; remove one of the includes\n");
  CHECK(faults_in_files(scenario_text(R"({"include":"bad.json"})"), files).starts_with("bad.json\n1:41"));
  CHECK(faults_in_files(scenario_text(R"({"include":"broken.json"})"), files).starts_with("broken.json\n"));
}

}  // namespace
}  // namespace symplant::test
