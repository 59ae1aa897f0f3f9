// Tests of symplant watch: messages, files and exit codes.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "../compare/compare_support.hpp"
#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

const std::string kGood =
    "0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; 2000 L_P_CL_I_CLOSED 1; 3000";
const std::string kLate =
    "0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; 2424 L_P_CL_I_CLOSED 1; 3000";

class WatchTool {
 public:
  WatchTool() {
    write("clamp.csv", list_text(bits({"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED"})));
    trace("good.jsonl", kGood);
    trace("late.jsonl", kLate);
  }

  std::string path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  void trace(const std::string& name, const std::string& changes) const {
    write(name, trace_text(changes, R"(,"cycle":10000000)"));
  }
  ToolRun run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"watch", path("clamp.csv")});
    base::DiskFileSystem files;
    return run_tool(arguments, files);
  }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("watch: A good recording has the exit code 0 and one summary") {
  WatchTool tool;
  const ToolRun run = tool.run({tool.path("good.jsonl")});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "good.jsonl: 3 s, 4 of 4 symbols, resolution 0.01 s, margin 20 %\n"));
  CHECK(contains(run.out, "no anomaly in 1 move of 1 device\n"));
}

TEST_CASE("watch: An anomaly is one sentence with the rows of the list, and gives the exit code 1") {
  WatchTool tool;
  const ToolRun run = tool.run({tool.path("late.jsonl")});
  CHECK(run.code == 1);
  CHECK(contains(run.out,
                 "at 2.42 s: L_P_CL arrived late in CLOSED: 1.42 s after O_CLOSED (clamp.csv:5), allowed 0.8 s to 1.2 "
                 "s (the model's 1 s with a margin of 0.2 s)\n1 anomaly of 1 device, in 1 move of 1 device\n"));
  CHECK(tool.run({tool.path("late.jsonl"), "--margin", "50%"}).code == 0);
}

TEST_CASE("watch --findings and --junit have what the terminal shows") {
  WatchTool tool;
  CHECK(tool.run({tool.path("late.jsonl"), "--findings", tool.path("f.jsonl"), "--junit", tool.path("w.xml")}).code ==
        1);
  const json line = json::parse(read_bytes(tool.path("f.jsonl")));
  CHECK(line.at("t") == 2424000000);
  CHECK(line.at("finding") == "late");
  CHECK(line.at("of") == "L_P_CL");
  CHECK(line.at("took") == 1424000000);
  CHECK(line.at("max") == 1000000000);
  CHECK(line.at("symbols").at(0).at("symbol") == "L_P_CL_O_CLOSED");
  CHECK(line.at("symbols").at(0).at("row") == 5);
  CHECK(line.at("symbols").size() == 3);
  const std::string junit = read_bytes(tool.path("w.xml"));
  CHECK(contains(junit, R"(tests="2" failures="1" errors="0" time="3")"));
  CHECK(contains(junit, R"(name="L_P_CL" time="3">)"));
  CHECK(contains(junit, "late: at 2.42 s: L_P_CL arrived late"));
}

TEST_CASE("watch: Of the anomalies of one kind and move the first is shown, and the others are counted") {
  WatchTool tool;
  std::string changes = "0 L_P_CL_I_OPEN 1; ";
  for (int i = 1; i <= 5; ++i) {
    changes += std::to_string(1000 * i) + " L_P_CL_I_OPEN 0; " + std::to_string(1000 * i + 100) + " L_P_CL_I_OPEN 1; ";
  }
  tool.trace("flicker.jsonl", changes + "9000");
  const ToolRun run = tool.run({tool.path("flicker.jsonl")});
  CHECK(contains(run.out,
                 "... L_P_CL from OPEN to ?: 4 more unexpected until 5 s\nof each device:\n  L_P_CL  5 unexpected, "
                 "first at 1 s\n5 anomalies of 1 device"));
  CHECK(run.out.find("at 2 s: ") == run.out.npos);
  tool.run({tool.path("flicker.jsonl"), "--findings", tool.path("f.jsonl")});
  const std::string findings = read_bytes(tool.path("f.jsonl"));
  CHECK(std::count(findings.begin(), findings.end(), '\n') == 5);
}

TEST_CASE("watch: What cannot be read is reported, with what to do") {
  WatchTool tool;
  tool.write("other.jsonl", trace_text("0 L_P_CM_I_OPEN 1; 5 L_P_CM_I_CLOSED 0", R"(,"recorded":true)"));
  const ToolRun other = tool.run({tool.path("other.jsonl")});
  CHECK(other.code == 2);
  CHECK(contains(other.err, "is a symbol of"));
  CHECK(contains(other.err, "`L_P_CM_I_OPEN` (did you mean `L_P_CL_I_OPEN`?)"));
  CHECK(contains(other.err, "give `--rename FILE`"));
  CHECK(tool.run({tool.path("absent.jsonl")}).code == 2);
  const ToolRun margin = tool.run({tool.path("good.jsonl"), "--margin", "much"});
  CHECK(margin.code == 2);
  CHECK(contains(margin.err, "`much` is not a share: write a number and %, such as 20%"));
  tool.trace("more.jsonl", kGood + "; 4000 X_I_A 1");
  CHECK(contains(tool.run({tool.path("more.jsonl")}).err, "1 name of"));
}

TEST_CASE("watch: A recording that shows no move is no success") {
  WatchTool tool;
  tool.trace("still.jsonl", "0 L_P_CL_I_OPEN 1; 9000");
  const ToolRun run = tool.run({tool.path("still.jsonl")});
  CHECK(run.code == 1);
  CHECK(contains(run.err, "error: nothing was judged: the recording shows no move"));
}

TEST_CASE("watch --learned: Its path may be relative although that of the plant is absolute, and its findings show") {
  WatchTool tool;
  const std::string learned = std::filesystem::relative(tool.path("learned.json")).string();
  tool.write("learned.json", R"({"symplant": 1, "times": {"L_P_CL": {"OPEN->CLOSED": {"takes": "1.4s"}}}})");
  CHECK(tool.run({tool.path("late.jsonl"), "--learned", learned}).code == 0);
  tool.write("learned.json", R"({"symplant": 1, "times": {"L_P_CX*": {"OPEN->CLOSED": {"takes": "1.4s"}}}})");
  CHECK(contains(tool.run({tool.path("late.jsonl"), "--learned", learned}).err, "L_P_CX*"));
  const ToolRun absent = tool.run({tool.path("late.jsonl"), "--learned", "no/learned.json"});
  CHECK(absent.code == 2);
  CHECK(contains(absent.err, "no/learned.json"));
  CHECK(absent.err.find("+times") == absent.err.npos);
}

TEST_CASE("watch: Options of a recording are for a recording, and those of a link for a link") {
  WatchTool tool;
  CHECK(contains(tool.run({tool.path("good.jsonl"), "--until", "1s"}).err, "`--every` and `--until` are for `--link`"));
  CHECK(contains(tool.run({tool.path("good.jsonl"), "--every", "1s"}).err, "`--every` and `--until` are for `--link`"));
  CHECK(contains(tool.run({"--link", "modbus-tcp://h", "--rename", "x"}).err, "are for a TRACE"));
}

TEST_CASE("watch: Results replace neither an input nor each other") {
  WatchTool tool;
  const std::string good = read_bytes(tool.path("good.jsonl"));
  CHECK(tool.run({tool.path("good.jsonl"), "--findings", tool.path("good.jsonl")}).code == 2);
  CHECK(tool.run({tool.path("good.jsonl"), "--junit", tool.path("clamp.csv")}).code == 2);
  CHECK(tool.run({tool.path("good.jsonl"), "--junit", tool.path("r"), "--findings", tool.path("r")}).code == 2);
  CHECK(read_bytes(tool.path("good.jsonl")) == good);
  CHECK(tool.run({tool.path("good.jsonl"), "--findings", tool.path("no/f.jsonl")}).code == 3);
}

constexpr const char* kCylinder =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
    "VAR_GLOBAL,LINE_S1_CYL_O_OUT,Y0020,%QX32,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_O_IN,Y0021,%QX33,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_I_OUT,X0010,%IX16,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_I_IN,X0011,%IX17,BOOL,FALSE,\n";

ToolRun watch_link(std::vector<std::string> arguments) {
  MemoryFileSystem files;
  files.files["list.csv"] = kCylinder;
  arguments.insert(arguments.begin(), {"watch", "list.csv"});
  return run_tool(arguments, files);
}

TEST_CASE("watch --link: What an input does that nothing caused is shown, and nothing is written to the PLC") {
  modbus::ModbusPlc plc;
  plc.with([](modbus::PlcMemory& memory) { memory.discrete_inputs[17] = 1; });
  std::thread hand([&plc] {
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    plc.with([](modbus::PlcMemory& memory) {
      memory.discrete_inputs[17] = 0;
      memory.discrete_inputs[16] = 1;
    });
  });
  const std::string url = "modbus-tcp://127.0.0.1:" + std::to_string(plc.port());
  const ToolRun run = watch_link({"--link", url, "--until", "1500ms", "--every", "20ms"});
  hand.join();
  CHECK(run.code == 1);
  CHECK(contains(run.out, "4 of 4 symbols, resolution 0."));
  CHECK(contains(run.out,
                 "LINE_S1_CYL went from IN to OUT, and nothing caused it: LINE_S1_CYL_I_OUT (X0010, "
                 "list.csv:4) came on"));
  CHECK(contains(run.out, "1 anomaly of 1 device, in 1 move of 1 device"));
  CHECK(plc.written().empty());
}

TEST_CASE("watch --link: A PLC that goes away is silent at once, and does not hold up the end") {
  std::optional<modbus::ModbusPlc> plc(std::in_place);
  const std::string url = "modbus-tcp://127.0.0.1:" + std::to_string(plc->port());
  std::thread power([&plc] {
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    plc.reset();
  });
  const ToolRun run = watch_link({"--link", url, "--until", "1500ms", "--every", "20ms"});
  power.join();
  CHECK(run.code == 1);
  CHECK(contains(run.out, "nothing was read for 0."));
}

TEST_CASE("watch --link: A PLC that does not answer gives the exit code 3") {
  const ToolRun run = watch_link({"--link", "modbus-tcp://127.0.0.1:1", "--until", "100ms"});
  CHECK(run.code == 3);
  CHECK(contains(run.err, "error: nothing was watched: there was no complete reading of the PLC"));
}

TEST_CASE("watch needs one recording or one link") {
  CHECK(contains(watch_link({}).err, "error: nothing to watch: give a TRACE, or `--link URL`"));
  CHECK(contains(watch_link({"t.jsonl", "--link", "modbus-tcp://h"}).err, "give one of them"));
  CHECK(contains(watch_link({"--link", "modbus-tcp-server://:1502"}).err, "is not a link to a PLC that can be read"));
  CHECK(contains(watch_link({"--link", "modbus-tcp://h", "--every", "1us"}).err, "write a time from 1ms"));
}

TEST_CASE("watch --learned: Its times win over those of the plant, also for a list") {
  WatchTool tool;
  tool.write("learned.json", R"({"symplant": 1, "times": {"L_P_CL": {"OPEN->CLOSED": {"takes": "1.4s"}}}})");
  CHECK(tool.run({tool.path("late.jsonl"), "--learned", tool.path("learned.json")}).code == 0);
  CHECK(contains(tool.run({tool.path("good.jsonl"), "--learned", tool.path("learned.json")}).out,
                 "L_P_CL arrived early in CLOSED: 1 s after O_CLOSED (clamp.csv:5), allowed 1.12 s to 1.68 s"));
  tool.write("plant.json", R"({"symplant": 1, "symbols": ["clamp.csv"],
      "times": {"L_P_CL": {"OPEN->CLOSED": {"takes": "5s"}}}})");
  base::DiskFileSystem files;
  CHECK(run_tool({"watch", tool.path("plant.json"), tool.path("late.jsonl")}, files).code == 1);
  CHECK(run_tool({"watch", tool.path("plant.json"), tool.path("late.jsonl"), "--learned", tool.path("learned.json")},
                 files)
            .code == 0);
  tool.write("learned.json", R"({"symplant": 1, "times": {"L_P_CL": {"OPEN->AWAY": {"takes": "1.4s"}}}})");
  const ToolRun unknown = tool.run({tool.path("late.jsonl"), "--learned", tool.path("learned.json")});
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "learned.json:1:"));
  CHECK(tool.run({tool.path("late.jsonl"), "--learned", tool.path("absent.json")}).code == 2);
}

/// A clamp that closes and opens `times` times, each move in `takes` ms and up to 20 ms more.
std::string cycles(int times, int takes) {
  std::string changes = "0 L_P_CL_I_OPEN 1";
  const auto add = [&](int time, const char* symbol, int value) {
    changes += "; " + std::to_string(time) + " L_P_CL_" + symbol + " " + std::to_string(value);
  };
  for (int i = 0; i < times; ++i) {
    for (const bool closes : {true, false}) {
      const int begin = 1000 + i * 6000 + (closes ? 0 : 3000);
      const int end = begin + 40 + takes + 10 * (i % 3);
      add(begin, closes ? "O_OPEN" : "O_CLOSED", 0);
      add(begin, closes ? "O_CLOSED" : "O_OPEN", 1);
      add(begin + 40, closes ? "I_OPEN" : "I_CLOSED", 0);
      add(end, closes ? "I_CLOSED" : "I_OPEN", 1);
    }
  }
  return changes;
}

TEST_CASE("watch --learned: Times that slowly leave those of `symplant learn` are one finding for each move") {
  WatchTool tool;
  tool.trace("before.jsonl", cycles(40, 900));
  tool.trace("worn.jsonl", cycles(40, 990));
  base::DiskFileSystem files;
  REQUIRE(run_tool({"learn", tool.path("clamp.csv"), tool.path("before.jsonl"), "-o", tool.path("learned.json")}, files)
              .code == 0);
  CHECK(tool.run({tool.path("before.jsonl"), "--learned", tool.path("learned.json")}).code == 0);
  const ToolRun run = tool.run({tool.path("worn.jsonl"), "--learned", tool.path("learned.json")});
  CHECK(run.code == 1);
  CHECK(contains(run.out, "2 anomalies of 1 device"));
  CHECK(contains(run.out, "drift"));
}

}  // namespace
}  // namespace symplant::test
