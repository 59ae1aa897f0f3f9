// Tests of the score in symplant check: texts, JSON, required scores.
#include <nlohmann/json.hpp>

#include "app/min_score.hpp"
#include "app_support.hpp"

namespace symplant::test {
namespace {

/// 6 of 10 symbols are paired, 7 accounted for.
MemoryFileSystem two_thirds() {
  MemoryFileSystem files;
  files.files["list.csv"] =
      list_text(bits({"L_P1_D_O_A", "L_P1_D_I_A", "L_P1_D_O_B", "L_P1_D_I_B", "L_P2_D_O_A", "L_P2_D_I_A",
                      "L_P2_E_I_AIR*", "L_P2_F_I_BUTTON1", "L_P2_F_I_BUTTON2", "START"}));
  return files;
}

ToolRun check_list(std::vector<std::string> options) {
  MemoryFileSystem files = two_thirds();
  options.insert(options.begin(), {"check", "list.csv"});
  return run_tool(options, files);
}

TEST_CASE("check: The score is a line of the summary") {
  const ToolRun run = check_list({});
  CHECK(contains(run.out,
                 "list.csv: of 10 BOOL I/O symbols 6 (60 %) paired, 7 (70 %) accounted for: 1 constant, 0 operator, 0 "
                 "data\nlist.csv: 9 of 10 I/O names follow"));
  CHECK_FALSE(contains(run.out, "left over"));
}

TEST_CASE("check: Sensors of parts, inputs that follow and the operations that move them are accounted for") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"L_P1_BELT_O_RUN", "L_P1_LAMP_O_ON", "L_P1_HORN_O_ON", "L_P1_EYE_I_PART",
                                            "L_P1_READY_I_ON", "L_P1_BUTTON_I_PUSH"}));
  files.files["plant.json"] = R"({ "symplant": 1, "symbols": ["list.csv"],
    "follow": { "L_P1_READY_I_ON": "L_P1_LAMP_O_ON" },
    "material": { "kinds": { "box": { "length": "1 m" } },
      "tracks": { "CV": { "length": "2 m", "drives": [ { "forward": "L_P1_BELT.RUN", "speed": "1 m/s" } ],
                          "sensors": [ { "symbol": "L_P1_EYE_I_PART", "at": "1 m" } ], "end": "out" } },
      "sources": [ { "name": "boxes", "at": "CV", "kind": "box" } ] } })";
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  INFO(run.out);
  CHECK(contains(run.out,
                 "of 6 BOOL I/O symbols 0 (0 %) paired, 4 (67 %) accounted for: 0 constant, 0 operator, 0 data, 1 "
                 "sensor of parts, 1 by `follow`, 2 read by `material`, `values`, `follow` or `malfunctions`"));
}

TEST_CASE("check --verbose: Stations are shown worst first, then the shapes that are left over") {
  const ToolRun run = check_list({"--verbose"});
  INFO(run.out);
  CHECK(contains(run.out,
                 "  station                   symbols   paired  accounted for  left over\n"
                 "  L_P2                            5     40 %           60 %          2\n"
                 "  (none)                          1      0 %            0 %          1\n"
                 "  L_P1                            4    100 %          100 %          0\n"
                 "  left over, the most frequent shapes first; # is a number:\n"
                 "       2 symbols like L_P#_F_I_BUTTON# have no operation (L_P2_F_I_BUTTON1)\n"
                 "       1 symbol like START matches no rule (START)\n"));
}

TEST_CASE("check --verbose: At most 20 stations and 20 shapes are shown, the rest is counted") {
  MemoryFileSystem files;
  std::vector<std::string> names;
  for (char c = 'A'; c <= 'Z'; ++c) names.push_back(std::string("L_P") + c + "_D_I_BUTTON");
  files.files["list.csv"] = list_text(bits(names));
  const std::string text = run_tool({"check", "list.csv", "--verbose"}, files).out;
  CHECK(contains(text, "\n  and 6 more stations\n"));
  CHECK(contains(text, "\n  and 6 more symbols of 6 shapes\n"));
}

TEST_CASE("check: Under a custom naming rule the shapes that are left over are shown without --verbose") {
  MemoryFileSystem files;
  files.files["list.csv"] =
      list_text({{"S1_Q_A", "", "BOOL", "FALSE", "%QX0"}, {"S2_Q_A", "", "BOOL", "FALSE", "%QX1"}});
  files.files["naming.json"] =
      R"({"symplant-naming": 1, "rules": [{"pattern": "{process}_{direction}_{device}", "task": "ON"}]})";
  const std::string text = run_tool({"check", "list.csv", "--naming", "naming.json"}, files).out;
  CHECK(contains(
      text, "       2 symbols like S#_Q_A have no event (S1_Q_A)\nlist.csv: of 2 BOOL I/O symbols 0 (0 %) paired"));
  CHECK_FALSE(contains(text, "station  "));
}

TEST_CASE("check: The JSON has the score of each plant on all levels") {
  const auto result = nlohmann::json::parse(check_list({"--format", "json"}).out);
  const auto& plant = result.at("plants").at(0);
  CHECK(plant.at("plant") == "list.csv");
  const auto& score = plant.at("score");
  CHECK(score.at("total") ==
        nlohmann::json::parse(R"({"symbols": 10, "paired": 6, "constant": 1, "operator": 0, "data": 0, "interlock": 0,
    "parts": 0, "follow": 0, "condition": 0, "accounted": 7, "left_over": {"no_rule": 1, "no_operation": 2}})"));
  CHECK(score.at("lists").at(0).at("list") == "list.csv");
  CHECK(score.at("lines").size() == 2);
  CHECK(score.at("stations").at(1).at("process") == "P2");
  CHECK(score.at("stations").at(1).at("paired") == 2);
  CHECK(score.at("devices").at(0).at("device") == "L_P1_D");
  CHECK(score.at("left_over").at(0) ==
        nlohmann::json::parse(
            R"({"shape": "L_P#_F_I_BUTTON#", "reason": "no_operation", "symbols": 2, "example": "L_P2_F_I_BUTTON1"})"));
  CHECK(score.at("questions").at("shapes").empty());
  const auto unreadable = nlohmann::json::parse(run_lists({"check", "--format", "json", "empty.csv"}).out);
  CHECK_FALSE(unreadable.contains("plants"));
}

TEST_CASE("check --min-score: A score below gives exit code 1 and one line, in every format") {
  for (const char* format : {"text", "json", "sarif", "junit"}) {
    INFO(format);
    const ToolRun good = check_list({"--format", format, "--min-score", "paired=0.6,accounted=70%"});
    CHECK(good.code == 0);
    CHECK_FALSE(contains(good.err, "error"));
    const ToolRun bad = check_list({"--format", format, "--min-score", "paired=0.8,accounted=70%"});
    CHECK(bad.code == 1);
    CHECK(
        contains(bad.err,
                 "error: list.csv: 6 of 10 BOOL I/O symbols (60.0 %) are paired, 2 fewer than `--min-score paired=0.8` "
                 "requires\n"));
    CHECK_FALSE(contains(bad.err, "accounted"));
  }
}

TEST_CASE("check --min-score: In JUnit each required score is a test") {
  const ToolRun run = check_list({"--format", "junit", "--min-score", "paired=0.8,accounted=0.7"});
  CHECK(contains(run.out, "<testcase classname=\"list.csv\" name=\"min-score accounted=0.7\" time=\"0\"/>"));
  CHECK(contains(run.out,
                 "name=\"min-score paired=0.8\" time=\"0\">\n      <failure message=\"6 of 10 BOOL I/O symbols"));
  CHECK(contains(run.out, "failures=\"1\""));
}

TEST_CASE("check --min-score: Anything but a score and a share is a usage error") {
  for (const char* text : {"paired", "paired=", "paired=1.1", "paired=101%", "paired=-0.1", "paired=nan", "paired=1e-1",
                           "pared=0.3", "=0.3", "0.3", "paired=0.3x"}) {
    INFO(text);
    const ToolRun run = check_list({"--min-score", text});
    CHECK(run.code == 2);
    CHECK(contains(run.err, "--min-score"));
    CHECK(run.out.empty());
  }
}

TEST_CASE("A required score is compared exactly") {
  score::Counts counts;
  for (int i = 0; i < 10; ++i) counts.add(i < 3 ? name::Account::modelled : name::Account::no_event);
  for (const char* reached : {"paired=0.3", "paired=30%", "accounted=0.3", "paired=0"}) {
    CHECK_FALSE(app::failed(*app::read_min_score(reached), counts));
  }
  CHECK(app::failed(*app::read_min_score("paired=0.301"), counts) ==
        "3 of 10 BOOL I/O symbols (30.0 %) are paired, 1 fewer than `--min-score paired=0.301` requires");
  CHECK(app::failed(*app::read_min_score("accounted=100%"), score::Counts()));
  CHECK_FALSE(app::failed(*app::read_min_score("accounted=0%"), score::Counts()));
}

}  // namespace
}  // namespace symplant::test
