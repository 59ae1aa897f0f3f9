// Runs with scenarios and files: exit codes, messages, and errors before any output.
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "support/golden.hpp"
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "support/vcd.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/files_apart.hpp"
#include "symplant/host/junit.hpp"
#include "symplant/host/run.hpp"
#include "symplant/trace/junit_xml.hpp"

namespace symplant::test {
namespace {

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/// A vehicle and a door that disables it, one requirement, a folder for files.
struct Cell {
  Cell() : tables(names(), reported()) {}

  static std::vector<std::string> names() {
    return {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1", "DOOR_I_SHUT1", "DOOR_I_OPEN2"};
  }
  static Reported reported() {
    Reported reported;
    reported.disables("DOOR", "OPEN2", "AGV");
    reported.description.requirements.push_back(
        {"both <at> \"once\" \x01", "L_P_AGV_O_P1 and L_P_AGV_O_P2", "", "", 0});
    reported.description.requirements.push_back({"arrives", "", "L_P_AGV_O_P2", "L_P_AGV.P2", 60 * tables::kSecond});
    return reported;
  }
  Outcome run(const std::string& steps) {
    options.scenario = folder.write("s.json", R"({"symplant-scenario":1,"steps":[)" + steps + "]}");
    return run();
  }
  Outcome run() const {
    std::ostringstream out;
    std::ostringstream err;
    const std::string input = folder / "plant.json";
    const std::string_view inputs[] = {input};
    const int code = host::run({.tables = tables.rows, .ignored = ignored, .inputs = inputs}, options, out, err);
    return {code, out.str(), err.str()};
  }
  std::string file(const std::string& name) const { return read_bytes(folder / name); }

  BenchTables tables;
  TemporaryFolder folder;
  host::RunOptions options;
  std::vector<host::IgnoredFinding> ignored;
};

const std::string kDrive = R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"at":"2s","expect":"L_P_AGV.P2"})";

TEST_CASE("A scenario whose expectations hold gives 0 and a message, and the run ends with its last step") {
  Cell cell;
  const Outcome outcome = cell.run(kDrive);
  CHECK(outcome.code == host::kGood);
  CHECK(contains(outcome.out, "s.json: 2 steps, 1 with expectations\n"));
  CHECK(contains(outcome.out, "ended at 2 s: the scenario is over\nexpectations: 1 held, 0 failed, 0 not reached\n"));
  CHECK(outcome.err == "");
}

TEST_CASE("A failed or unreached expectation gives 1 and is reported with its location") {
  Cell cell;
  const Outcome failed = cell.run(R"({"at":"1s","expect":"L_P_AGV.P2"})");
  CHECK(failed.code == host::kFindings);
  CHECK(contains(failed.err,
                 "s.json:1: error: expected `L_P_AGV.P2` at 1 s\n    L_P_AGV has been in P1 since the start"));
  CHECK(contains(failed.out, "expectations: 0 held, 1 failed, 0 not reached"));
  cell.options.until = tables::kSecond;
  const Outcome cut = cell.run(kDrive);
  CHECK(cut.code == host::kFindings);
  CHECK(contains(cut.err, "`L_P_AGV.P2` was not reached, since the run ended at 1 s"));
  CHECK(contains(cut.out, "ended at 1 s: --until is reached"));
}

TEST_CASE("A violated requirement gives 1, a finding only on request") {
  Cell cell;
  const Outcome violated = cell.run(R"({"at":"1s","set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}},{"at":"3s"})");
  CHECK(violated.code == host::kFindings);
  CHECK(contains(violated.out, "requirements: 1 held, 1 violated\n"));
  CHECK(contains(violated.out, "pending at the end: `arrives`"));
  CHECK(contains(violated.err, "error: 1 s: requirement violated: `both <at> \"once\" ?`"));
  CHECK(contains(violated.err, "warning: 1 s: conflicting operations: L_P_AGV (P1)"));
  const std::string disabled = R"({"at":"1s","state":{"L_P_DOOR":"OPEN2"}},{"at":"2s","set":{"L_P_AGV_O_P2":true}})";
  const Outcome good = cell.run(disabled);
  CHECK(good.code == host::kGood);
  CHECK(contains(good.err,
                 "warning: 2 s: command to a disabled unit: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), "
                 "came on while L_P_AGV (P1, disabled) cannot move, disabled by L_P_DOOR in OPEN2"));
  CHECK(contains(good.out, "findings: command to a disabled unit (1)\n"));
  cell.options.fail_on_findings = true;
  CHECK(cell.run(disabled).code == host::kFindings);
  CHECK(cell.run(kDrive).code == host::kGood);
}

TEST_CASE("Findings that the description ignores are counted apart, up to their last day") {
  Cell cell;
  cell.options.fail_on_findings = true;
  const std::string disabled = R"({"at":"1s","state":{"L_P_DOOR":"OPEN2"}},{"at":"2s","set":{"L_P_AGV_O_P2":true}})";
  const auto ignoring = [&](const host::IgnoredFinding& entry) {
    cell.ignored = {entry};
    return cell.run(disabled);
  };
  for (const std::string_view of : {"", "L_P_AGV_O_P2", "L_P_AGV", "l_p_a*"}) {  // its symbol, or the device
    INFO(of);
    const Outcome outcome = ignoring({"command to a disabled unit", of, ""});
    CHECK(outcome.code == host::kGood);
    CHECK(outcome.err == "");
    CHECK(contains(outcome.out, "findings: 1 ignored, as plant.json says\n"));
    CHECK_FALSE(contains(outcome.out, "(1)"));
  }
  CHECK(ignoring({"command to a disabled unit", "L_P_DOOR*", ""}).code == host::kFindings);
  CHECK(ignoring({"lost command", "", ""}).code == host::kFindings);
  CHECK(ignoring({"command to a disabled unit", "", "2999-12-31"}).code == host::kGood);
  CHECK(ignoring({"command to a disabled unit", "", "2020-01-01"}).code == host::kFindings);
  cell.ignored = {{"requirement violated", "", ""}};
  CHECK(cell.run(R"({"at":"1s","set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}},{"at":"3s"})").code == host::kFindings);
}

TEST_CASE("A violated requirement names the force that caused it, until it is released") {
  Cell cell;
  const std::string force = R"({"at":"500ms","force":{"L_P_AGV_O_P1":true}},)";
  const std::string both = R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"at":"3s"})";
  CHECK(contains(cell.run(force + both).err, "L_P_AGV_O_P1 is forced to on since 0.5 s"));
  const std::string released =
      R"({"at":"600ms","release":["L_P_AGV_O_P1"]},{"at":"700ms","set":{"L_P_AGV_O_P1":true}},)";
  CHECK_FALSE(contains(cell.run(force + released + both).err, "is forced"));
}

TEST_CASE("A scenario with faults gives 2, each fault with its location, and writes nothing") {
  Cell cell;
  cell.options.trace = cell.folder / "trace.jsonl";
  const Outcome outcome = cell.run("{\"at\":\"1s\",\"set\":{\"L_P_AGV_O_P3\":true}},\n{\"at\":\"0s\"}");
  CHECK(outcome.code == host::kBadInput);
  CHECK(contains(outcome.err, "s.json:1:51: error: symbol `L_P_AGV_O_P3` not found; did you mean `L_P_AGV_O_P"));
  CHECK(contains(outcome.err, "s.json:2:7: error: this time is before the `at` above"));
  CHECK(outcome.out == "");
  CHECK_FALSE(std::filesystem::exists(cell.options.trace));
  cell.options.scenario = cell.folder / "none.json";
  const Outcome missing = cell.run();
  CHECK(missing.code == host::kBadInput);
  CHECK(contains(missing.err, "cannot read the scenario"));
  cell.options.scenario = cell.folder.path();
  CHECK(cell.run().code == host::kBadInput);
}

TEST_CASE("No output may replace an input, or another output") {
  Cell cell;
  cell.folder.write("plant.json", "{}");
  const auto refused = [&](std::string host::RunOptions::*option, const std::string& path, const std::string& why) {
    const host::RunOptions before = cell.options;
    cell.options.*option = path;
    const Outcome outcome = cell.run(kDrive);
    CHECK(outcome.code == host::kBadInput);
    CHECK(contains(outcome.err, why));
    cell.options = before;
  };
  refused(&host::RunOptions::vcd, cell.folder / "plant.json", "is an input");
  refused(&host::RunOptions::junit, cell.folder / "s.json", "is an input");
  refused(&host::RunOptions::findings,
          cell.folder / "../" + std::filesystem::path(cell.folder.path()).filename().string() + "/s.json",
          "is an input");
  cell.options.trace = cell.folder / "t";
  refused(&host::RunOptions::stats, cell.folder / "t", "--trace and --stats would both write");
  cell.options.trace_limit = 1000;
  refused(&host::RunOptions::vcd, cell.folder / "t.1", "would both write");
  cell.options.trace = "-";
  refused(&host::RunOptions::vcd, "/dev/stdout", "would both write");
  cell.options.trace = cell.options.vcd = "/dev/null";
  CHECK(cell.run(kDrive).code == host::kGood);
}

TEST_CASE("An unwritable file gives 3, a full disk gives a warning") {
  Cell cell;
  for (auto option :
       {&host::RunOptions::vcd, &host::RunOptions::findings, &host::RunOptions::junit, &host::RunOptions::stats}) {
    cell.options.*option = "/no/such/folder/file";
    CHECK(cell.run(kDrive).code == host::kEnvironment);
    (cell.options.*option).clear();
  }
  if (!std::filesystem::exists("/dev/full")) return;
  cell.options.trace = "/dev/full";
  const Outcome full = cell.run(kDrive);
  CHECK(full.code == host::kGood);
  CHECK(contains(full.err, "warning: cannot write the trace `/dev/full`"));
}

TEST_CASE("A trace to standard output is its only content") {
  Cell cell;
  cell.options.trace = "-";
  const Outcome outcome = cell.run(kDrive);
  CHECK(outcome.out.starts_with("{\"symplant-trace\":1,"));
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 6);
  CHECK(contains(outcome.err, "ended at 2 s"));
}

TEST_CASE("Findings are written to their file with all details") {
  Cell cell;
  cell.options.findings = cell.folder / "f.jsonl";
  cell.run(R"({"at":"1s","set":{"L_P_AGV_O_P1":true}},{"at":"2s","set":{"L_P_AGV_O_P2":true}},{"at":"3s"})");
  std::istringstream lines(cell.file("f.jsonl"));
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(line.starts_with(R"({"t":2000000000,"finding":"conflicting operations","of":"L_P_AGV","operations":[)"));
  const auto first = nlohmann::json::parse(line);
  CHECK(first["operations"].size() == 2);
  CHECK(first["operations"][0]["symbol"] == "L_P_AGV_O_P2");
  CHECK(first["operations"][1]["address"] == "%QX3");
  REQUIRE(std::getline(lines, line));
  CHECK(nlohmann::json::parse(line)["of"] == "both <at> \"once\" \x01");
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("The JUnit report has a case for each expectation and requirement, and is valid XML") {
  Cell cell;
  cell.options.junit = cell.folder / "j.xml";
  cell.options.fail_on_findings = true;
  cell.run(kDrive + R"(,{"wait":"L_P_AGV.P1","within":"1s"},{"plus":"0s","set":{"L_P_AGV_O_P1":true}})");
  const std::string xml = cell.file("j.xml");
  CHECK(contains(xml, "<testsuites tests=\"5\" failures=\"3\" errors=\"0\" time=\"3\">"));
  CHECK(contains(xml, "name=\"step 2: expect `L_P_AGV.P2`\" time=\"2\"/>"));
  CHECK(
      contains(xml, "name=\"step 3: wait `L_P_AGV.P1` within 1 s\" time=\"3\">\n      <failure message=\"waited 1 s"));
  CHECK(contains(xml, "name=\"requirement: both &lt;at&gt; &quot;once&quot; \xEF\xBF\xBD\" time=\"3\">"));
  CHECK(contains(xml, "name=\"requirement: arrives\" time=\"3\"/>"));
  CHECK(contains(xml, "name=\"findings\""));
  CHECK(trace::xml_text("a\n\xC3\xA4\xFF\xED\xA0\x80&'") ==
        "a&#10;\xC3\xA4\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD&amp;'");
  if (std::system("python3 -c 'import xml.etree' 2>/dev/null") != 0) return;
  const std::string check =
      "python3 -c 'import sys, xml.etree.ElementTree as e; assert len(e.parse(sys.argv[1])."
      "findall(\".//testcase\")) == 5' ";
  CHECK(std::system((check + cell.options.junit).c_str()) == 0);
}

TEST_CASE("Acts are no expectations in summary, JUnit and statistics, but one that is not reached has failed") {
  Cell cell;
  cell.options.junit = cell.folder / "j.xml";
  cell.options.stats = cell.folder / "stats.json";
  const std::string steps = R"({"at":"0s","start":"L_P_AGV_I_P2 stuck off"},{"wait":"L_P_AGV.P1","within":"1s"},)"
                            R"({"at":"2s","start":"L_P_AGV slow"})";
  const Outcome good = cell.run(steps);
  CHECK(good.code == host::kGood);
  CHECK(contains(good.out, "3 steps, 1 with expectations\n"));
  CHECK(contains(good.out, "expectations: 1 held, 0 failed, 0 not reached\n"));
  CHECK(contains(cell.file("j.xml"), "<testsuites tests=\"3\" failures=\"0\""));
  CHECK(contains(cell.file("stats.json"), R"("expectations":{"held":1,"failed":0,"unreached":0})"));
  cell.options.until = tables::kSecond;
  const Outcome cut = cell.run(steps);
  CHECK(cut.code == host::kFindings);
  CHECK(contains(cut.out, "expectations: 1 held, 0 failed, 1 not reached\n"));
  CHECK(contains(cell.file("j.xml"), "<testsuites tests=\"4\" failures=\"1\""));
  CHECK(contains(cell.file("j.xml"), "name=\"step 3: needs malfunction `L_P_AGV slow`\""));
}

TEST_CASE("The VCD file contains bits, and states as strings, by their levels") {
  Cell cell;
  cell.options.vcd = cell.folder / "v.vcd";
  cell.run(kDrive);
  const Vcd vcd = read_vcd(cell.file("v.vcd"));
  CHECK(vcd.fault == "");
  CHECK(vcd.timescale == "1 ns");
  CHECK(vcd.last_time == "2000000000");
  const std::string agv = "symbols.L.P.AGV.";
  CHECK(vcd.variables.at(agv + "L_P_AGV").type == "string");
  CHECK(vcd.variables.at(agv + "L_P_AGV_O_P2").type == "wire");
  CHECK(contains(vcd.initial, agv + "L_P_AGV=P1"));
  CHECK(contains(vcd.initial, agv + "L_P_AGV_I_P1=1"));
  CHECK(vcd.changes ==
        std::vector<std::string>{"1000000000 " + agv + "L_P_AGV_I_P1=0", "1000000000 " + agv + "L_P_AGV_O_P2=1",
                                 "1000000000 " + agv + "L_P_AGV=P1->P2", "2000000000 " + agv + "L_P_AGV_I_P2=1",
                                 "2000000000 " + agv + "L_P_AGV=P2"});
}

TEST_CASE("Files start again at their limit, and each part can be read alone") {
  Cell cell;
  cell.options.trace = cell.folder / "t.jsonl";
  cell.options.vcd = cell.folder / "v.vcd";
  cell.options.trace_limit = 330;
  cell.run(R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"at":"3s","set":{"L_P_AGV_O_P2":false}},{"at":"4s"})");
  const std::string older = cell.file("t.jsonl.1");
  const std::string newer = cell.file("t.jsonl");
  CHECK(contains(older, "\"seed\":0"));
  CHECK(contains(newer, "\"seed\":0,\"clock\":\"virtual\",\"part\":"));
  CHECK(contains(newer, "\"values\":{\"L_P_AGV_I_P2\":true,"));
  const Vcd vcd = read_vcd(cell.file("v.vcd"));
  CHECK(vcd.fault == "");
  CHECK(vcd.values.at("symbols.L.P.AGV.L_P_AGV") == "P2");
  CHECK(std::filesystem::exists(cell.folder / "v.vcd.1"));
}

TEST_CASE("Statistics report the result of the run") {
  Cell cell;
  cell.options.stats = cell.folder / "s";
  cell.options.seed = 7;
  cell.run(kDrive);
  const auto stats = nlohmann::json::parse(cell.file("s"));
  CHECK(stats["symplant-stats"] == 1);
  CHECK(stats["seed"] == 7);
  CHECK(stats["plant_time"] == 2'000'000'000);
  CHECK(stats["changes"] == 5);
  CHECK(stats["expectations"]["held"] == 1);
  CHECK(stats["findings"]["lost command"] == 0);
  CHECK(stats["requirements"]["held"] == 2);
  CHECK_FALSE(stats.contains("cycles"));
  const nlohmann::json use = stats["utilization"];
  CHECK(use["from"] == 0);
  CHECK(use["to"] == stats["plant_time"]);
  tables::Time whole = 0;
  for (const nlohmann::json& time : use["devices"]["L_P_AGV"]["times"]) whole += time.get<tables::Time>();
  CHECK(whole == stats["plant_time"]);
}

TEST_CASE("In real time a scenario plays in cycles, and its end is that of the run") {
  Cell cell;
  cell.options.clock = host::RunOptions::Clock::real_time;
  cell.options.stats = cell.folder / "s";
  const Outcome outcome = cell.run(R"({"at":"15ms","state":{"L_P_AGV":"P2"}},{"plus":"5ms","expect":"L_P_AGV.P2"})");
  CHECK(outcome.code == host::kGood);
  CHECK(contains(outcome.out, "until the scenario is over"));
  CHECK(contains(outcome.out, "ended at 0.02 s"));
  CHECK(nlohmann::json::parse(cell.file("s"))["cycles"] == 2);
}

TEST_CASE("Statistics of a run with links report the state of each link") {
  Cell cell;
  cell.options.links = {"modbus-tcp-server://127.0.0.1:0", "loop:"};
  cell.options.until = 20 * kMs;
  cell.options.stats = cell.folder / "s";
  const Outcome outcome = cell.run();
  CHECK(outcome.err.starts_with("warning: 0.02 s: no PLC: "));
  CHECK(outcome.code == host::kGood);
  CHECK(contains(outcome.out, "; after 1 s without a request: operations hold, the plant runs on\nlink loop:\n"));
  const auto links = nlohmann::json::parse(cell.file("s"))["links"];
  REQUIRE(links.size() == 2);
  CHECK(contains(links[0]["link"].get<std::string>(), "modbus-tcp-server://127.0.0.1:"));
  CHECK(links[0]["state"] == "waiting");
  CHECK(links[0]["losses"] == 0);
  CHECK(links[0]["requests"] == 0);
  CHECK(links[1]["link"] == "loop:");
  CHECK(links[1]["state"] == "live");
}

TEST_CASE("A guarded run has the requested length for any scenario") {
  Cell cell;
  cell.options.rt_check = 100;
  cell.options.until = 100 * kMs;
  const Outcome refused = cell.run();
  CHECK(refused.code == host::kBadInput);
  CHECK(contains(refused.err, "error: `--rt-check` already sets the length of the run"));
  CHECK(refused.out.empty());
  cell.options.until.reset();
  const std::string steps = R"({"at":"15ms","state":{"L_P_AGV":"P2"}},{"plus":"5ms","expect":"L_P_AGV.P2"})";
  for (const auto clock : {host::RunOptions::Clock::virtual_time, host::RunOptions::Clock::real_time}) {
    cell.options.clock = clock;
    const Outcome whole = cell.run(steps);
    CHECK(contains(whole.out, "rt-check: 100 cycles, "));
    CHECK_FALSE(contains(whole.out, "not checked, since"));
  }
}

/// On its first flush, before the first cycle, it ends the run.
class EndedEarly final : public std::stringbuf {
  int sync() override {
    if (!std::exchange(done_, true)) std::raise(SIGTERM);
    return std::stringbuf::sync();
  }
  bool done_ = false;
};

TEST_CASE("A guarded run ended by a signal reports the missing cycles, and gives 1") {
  Cell cell;
  cell.options.rt_check = 100;
  for (const auto clock : {host::RunOptions::Clock::virtual_time, host::RunOptions::Clock::real_time}) {
    cell.options.clock = clock;
    EndedEarly reported;
    std::ostream out(&reported);
    std::ostringstream err;
    CHECK(host::run({.tables = cell.tables.rows}, cell.options, out, err) == host::kFindings);
    CHECK(contains(reported.str(), "rt-check: 100 of 100 cycles were not checked, since a signal ended the run\n"));
  }
}

TEST_CASE("Sizes are bytes with or without a unit") {
  CHECK(host::parse_size("1") == 1);
  CHECK(host::parse_size("500k") == 512'000);
  CHECK(host::parse_size("1G") == std::uint64_t{1} << 30);
  for (const char* wrong : {"", "0", "k", "1T", "-1", "1kk", "99999999999999999999", "18014398509481985k"}) {
    INFO(wrong);
    CHECK_FALSE(host::parse_size(wrong));
  }
}

}  // namespace
}  // namespace symplant::test
