// Tests of symplant learn: from the trace of a run to times, and back.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kActuations = R"("L_P_CL?": { "actuation": "bistable" }, "L_P_AXIS": { "actuation": "held" })";

/// The times of the real plant.
constexpr const char* kTruth = R"({
    "symplant": 1, "symbols": ["symbols.csv"],
    "devices": {
      "L_P_CL?": { "actuation": "bistable", "transitions": [
        { "from": "OPEN", "to": "CLOSED", "takes": "0.812s" },
        { "from": "CLOSED", "to": "OPEN", "after": "0.2s", "takes": { "min": "0.6s", "max": "0.8s" } } ] },
      "L_P_AXIS": { "actuation": "held", "transitions": [
        { "from": "UP", "to": "DOWN", "takes": "1.5s" }, { "from": "DOWN", "to": "UP", "takes": "0.7s" } ] },
      "L_P_MC": { "transitions": [ { "from": "RUN2", "to": "IDLE1", "automatic": true, "after": "5s" } ] },
      "L_P_PIN": { "transitions": [
        { "from": "RET", "to": "ADV", "takes": "0.3s" }, { "from": "ADV", "to": "RET", "takes": "0.45s" } ] }
    } })";

/// 20 cycles in which each device moves there and back.
constexpr const char* kCycles = R"({ "symplant-scenario": 1, "steps": [ { "repeat": 20, "steps": [
    { "plus": "0.1s", "set": { "L_P_CL1_O_OPEN": false, "L_P_CL1_O_CLOSED": true, "L_P_CL2_O_OPEN": false,
                               "L_P_CL2_O_CLOSED": true, "L_P_AXIS_O_DOWN": true, "L_P_MC_O_RUN2": true, "L_P_PIN_O_ADV": true } },
    { "wait": "L_P_AXIS.DOWN and L_P_CL1.CLOSED and L_P_CL2.CLOSED", "within": "5s" },
    { "plus": "0.05s", "set": { "L_P_CL1_O_OPEN": true, "L_P_CL1_O_CLOSED": false, "L_P_CL2_O_OPEN": true,
                                "L_P_CL2_O_CLOSED": false, "L_P_AXIS_O_DOWN": false, "L_P_MC_O_RUN2": false, "L_P_PIN_O_ADV": false } },
    { "plus": "0.1s", "set": { "L_P_AXIS_O_UP": true } },
    { "wait": "L_P_AXIS.UP", "within": "5s" },
    { "plus": "0.05s", "set": { "L_P_AXIS_O_UP": false } },
    { "wait": "L_P_MC.IDLE1 and L_P_CL1.OPEN and L_P_CL2.OPEN", "within": "9s" } ] } ] })";

/// A plant whose times are known, and files of one whose times are not.
class LearnFolder {
 public:
  LearnFolder() {
    folder_.write(
        "symbols.csv",
        list_text(bits({"L_P_CL1_I_OPEN", "L_P_CL1_I_CLOSED", "L_P_CL1_O_OPEN", "L_P_CL1_O_CLOSED", "L_P_CL2_I_OPEN",
                        "L_P_CL2_I_CLOSED", "L_P_CL2_O_OPEN", "L_P_CL2_O_CLOSED", "L_P_AXIS_I_UP", "L_P_AXIS_I_DOWN",
                        "L_P_AXIS_O_UP", "L_P_AXIS_O_DOWN", "L_P_MC_I_IDLE1", "L_P_MC_I_RUN2", "L_P_MC_O_RUN2",
                        "L_P_PIN_O_ADV", "L_P_PIN_I_ADV", "L_P_PIN_I_RET"})));
    folder_.write("truth.json", kTruth);
    folder_.write("cycles.json", kCycles);
    folder_.write("plant.json", plant(""));
    folder_.write("with-times.json", plant(R"("include": ["learned.json"], )"));
  }

  ToolRun run(const std::vector<std::string>& arguments) {
    const ToolRun run = run_tool(arguments, files_);
    INFO(run.out << run.err);
    CHECK(run.code == 0);
    return run;
  }

  /// Runs a plant, and learns with `plant` from its trace.
  Json learn(const std::string& runs, const std::string& trace, const std::string& plant, const std::string& output) {
    run({"run", file(runs), "--scenario", file("cycles.json"), "--trace", file(trace)});
    run({"learn", file(plant), file(trace), "-o", file(output)});
    return times(output);
  }

  Json times(const std::string& name) { return Json::parse(text(name), nullptr, true, true).at("times"); }
  std::string text(const std::string& name) { return read_bytes(file(name)); }
  std::string file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& content) { folder_.write(name, content); }
  base::FileSystem& files() { return files_; }

 private:
  static std::string plant(const std::string& include) {
    return R"({ "symplant": 1, )" + include + R"("symbols": ["symbols.csv"], "devices": { )" + kActuations + " } }";
  }

  TemporaryFolder folder_;
  base::DiskFileSystem files_;
};

tables::Time duration(const Json& json) { return *tables::parse_duration(json.get<std::string>()); }

TEST_CASE("learn: The times of a run are found, and a plant that includes them runs with them") {
  LearnFolder folder;
  const Json times = folder.learn("truth.json", "truth.jsonl", "plant.json", "learned.json");
  CHECK(times.at("L_P_CL1").at("OPEN->CLOSED") == Json({{"takes", "0.812s"}}));
  const Json& opens = times.at("L_P_CL1").at("CLOSED->OPEN");
  CHECK(opens.at("after") == "0.2s");
  const tables::Time least = duration(opens.at("takes").at("min"));
  const tables::Time most = duration(opens.at("takes").at("max"));
  CHECK(least >= 600 * tables::kMillisecond);
  CHECK(most <= 800 * tables::kMillisecond);
  CHECK(most - least >= 160 * tables::kMillisecond);
  CHECK(times.at("L_P_AXIS") ==
        Json({{"UP->DOWN", {{"takes", "1.5s"}}}, {"DOWN->UP", {{"takes", "0.7s"}}}, {"overrun", "0.15s"}}));
  CHECK(times.at("L_P_MC") == Json({{"IDLE1->RUN2", {{"takes", "1s"}}}, {"RUN2->IDLE1", {{"after", "5s"}}}}));
  CHECK(times.at("L_P_PIN") == Json({{"RET->ADV", {{"takes", "0.3s"}}}, {"ADV->RET", {{"takes", "0.45s"}}}}));

  Json again = folder.learn("with-times.json", "again.jsonl", "plant.json", "again.json");
  const Json& opens_again = again.at("L_P_CL1").at("CLOSED->OPEN");
  CHECK(opens_again.at("after") == "0.2s");
  CHECK(duration(opens_again.at("takes").at("min")) >= least);
  CHECK(duration(opens_again.at("takes").at("max")) <= most);
  for (const char* const device : {"L_P_CL1", "L_P_CL2"})
    again.at(device).at("CLOSED->OPEN") = times.at(device).at("CLOSED->OPEN");
  CHECK(again == times);
}

TEST_CASE("learn: A plant that includes the result gives the same file again") {
  LearnFolder folder;
  folder.learn("truth.json", "truth.jsonl", "plant.json", "learned.json");
  const std::string first = folder.text("learned.json");
  const ToolRun run = folder.run(
      {"learn", folder.file("with-times.json"), folder.file("truth.jsonl"), "-o", folder.file("learned.json")});
  CHECK(contains(run.err, "with-times.json takes it by \"include\": [\"learned.json\"]"));
  CHECK(folder.text("learned.json") == first);
}

TEST_CASE("learn: A file of times that was edited, or that is an input, is kept") {
  LearnFolder folder;
  folder.learn("truth.json", "truth.jsonl", "plant.json", "learned.json");
  folder.write("learned.json", folder.text("learned.json") + " ");
  std::vector<std::string> arguments{"learn", folder.file("plant.json"), folder.file("truth.jsonl"), "-o",
                                     folder.file("learned.json")};
  const ToolRun kept = run_tool(arguments, folder.files());
  CHECK(kept.code == 2);
  CHECK(contains(kept.err, "already exists, and may contain your work"));
  arguments.push_back("--force");
  CHECK(run_tool(arguments, folder.files()).code == 0);
  for (const char* const input : {"truth.jsonl", "plant.json", "symbols.csv"}) {
    arguments[4] = folder.file(input);
    CHECK(run_tool(arguments, folder.files()).code == 2);
  }
}

TEST_CASE("learn: A recording without a move of a device is code 1, and no file is written") {
  LearnFolder folder;
  folder.write("still.jsonl",
               "{\"symplant-trace\":1}\n{\"t\":0,\"symbol\":\"L_P_CL1_I_OPEN\",\"value\":true}\n{\"t\":9000000000}\n");
  const ToolRun run = run_tool(
      {"learn", folder.file("plant.json"), folder.file("still.jsonl"), "-o", folder.file("no.json")}, folder.files());
  CHECK(run.code == 1);
  CHECK(contains(run.err, "nothing was learned: the recordings show no move that the model explains, and no pair\n"));
  CHECK(contains(run.out, "devices that never moved (5): L_P_CL1, "));
  CHECK(!folder.files().exists(folder.file("no.json")));
}

TEST_CASE("learn: Pairs that names do not show are reported and written") {
  LearnFolder folder;
  folder.write("names.csv", list_text({{"PUMP", "", "BOOL", "FALSE", "%QX0"}, {"FLOW", "", "BOOL", "FALSE", "%IX0"}}));
  std::string trace = "{\"symplant-trace\":1,\"recorded\":true}\n";
  const auto add = [&](long ms, const std::string& symbol, bool on) {
    trace += "{\"t\":" + std::to_string(ms * tables::kMillisecond) + ",\"symbol\":\"" + symbol +
             "\",\"value\":" + (on ? "true" : "false") + "}\n";
  };
  add(0, "PUMP", false);
  add(0, "FLOW", false);
  for (long i = 0; i < 20; ++i) {
    const long begin = 10'000 * i + 137 * (i * i % 11) + 1000;
    add(begin, "PUMP", true);
    add(begin + 500, "FLOW", true);
    add(begin + 4000, "PUMP", false);
    add(begin + 4500, "FLOW", false);
  }
  folder.write("flow.jsonl", trace);
  std::vector<std::string> arguments{"learn", folder.file("names.csv"), folder.file("flow.jsonl"), "--links",
                                     folder.file("links.csv")};
  const ToolRun run = run_tool(arguments, folder.files());
  CHECK(run.code == 0);
  CHECK(contains(run.out, "   1  PUMP -> FLOW: 20 of 20 changes, after 0.5 s; off: 20 of 20 changes, after 0.5 s"));
  CHECK(contains(folder.text("links.csv"), "FLOW"));
  arguments.insert(arguments.end(), {"--refuse", "2"});
  const ToolRun refused = run_tool(arguments, folder.files());
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "--refuse 2: the pairs are 1 to 1"));
}

TEST_CASE("learn: A recording without a name of the plant is code 2, with a hint at --rename") {
  LearnFolder folder;
  folder.write("other.jsonl",
               "{\"symplant-trace\":1,\"recorded\":true}\n{\"t\":0,\"symbol\":\"L_P_CL1_I_OPN\",\"value\":true}\n{"
               "\"t\":9000000000}\n");
  const ToolRun run = run_tool({"learn", folder.file("plant.json"), folder.file("other.jsonl")}, folder.files());
  CHECK(run.code == 2);
  CHECK(contains(run.err, ": `L_P_CL1_I_OPN` (did you mean `L_P_CL1_I_OPEN`?); give `--rename FILE`"));
}

TEST_CASE("learn: The `include` of the result is relative to the description") {
  LearnFolder folder;
  folder.run({"run", folder.file("truth.json"), "--scenario", folder.file("cycles.json"), "--trace",
              folder.file("truth.jsonl")});
  std::filesystem::create_directories(folder.file("out/deep"));
  const ToolRun run = folder.run(
      {"learn", folder.file("plant.json"), folder.file("truth.jsonl"), "-o", folder.file("out/deep/l.json")});
  CHECK(contains(run.err, "plant.json takes it by \"include\": [\"out/deep/l.json\"]"));
  folder.write("deep.json",
               R"({ "symplant": 1, "include": ["out/deep/l.json"], "symbols": ["symbols.csv"], "devices": { )" +
                   std::string(kActuations) + " } }");
  folder.run({"check", folder.file("deep.json")});
  const ToolRun list =
      folder.run({"learn", folder.file("symbols.csv"), folder.file("truth.jsonl"), "-o", folder.file("list.json")});
  CHECK(contains(list.err, "; a plant.json next to "));
}

TEST_CASE("learn: Times and links are two files, and one that is not written is named") {
  LearnFolder folder;
  folder.run({"run", folder.file("truth.json"), "--scenario", folder.file("cycles.json"), "--trace",
              folder.file("truth.jsonl")});
  std::vector<std::string> arguments{
      "learn",   folder.file("plant.json"), folder.file("truth.jsonl"), "-o", folder.file("a.json"),
      "--links", folder.file("./a.json")};
  const ToolRun same = run_tool(arguments, folder.files());
  CHECK(same.code == 2);
  CHECK(contains(same.err, "-o and --links name the same file"));
  CHECK(!folder.files().exists(folder.file("a.json")));
  arguments.back() = folder.file("links.csv");
  const ToolRun run = folder.run(arguments);
  CHECK(contains(run.err, "links.csv is not written: the recordings show no pairs that names do not show"));
  CHECK(!folder.files().exists(folder.file("links.csv")));
}

TEST_CASE("learn: What cannot be read is code 2") {
  LearnFolder folder;
  folder.write("broken.jsonl", "{\"symplant-trace\":1}\n{\"t\":0,\"symbol\"\n{\"t\":1}\n");
  const ToolRun broken = run_tool({"learn", folder.file("plant.json"), folder.file("broken.jsonl")}, folder.files());
  CHECK(broken.code == 2);
  CHECK(contains(broken.err, "broken.jsonl:2"));
  CHECK(run_tool({"learn", folder.file("plant.json"), folder.file("missing.jsonl")}, folder.files()).code == 2);
  CHECK(run_tool({"learn", folder.file("plant.json")}, folder.files()).code == 2);
  CHECK(run_tool({"learn", folder.file("missing.json"), folder.file("broken.jsonl")}, folder.files()).code == 2);
}

}  // namespace
}  // namespace symplant::test
