// Files that say whether a run was good, of runs that fail.
#include "symplant/host/result_files.hpp"

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "support/golden.hpp"
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"
#include "symplant/link/net/listener.hpp"

namespace symplant::test {
namespace {

namespace fs = std::filesystem;

const std::string kGoodScenario = R"({"symplant-scenario":1,"steps":[{"at":"1s","expect":"L_P_AGV.P1"}]})";

/// A result, and the result files of its last run.
struct ResultRun {
  ResultRun() { set_options(); }
  void set_options() {
    options = {};
    options.scenario = folder.write("s.json", kGoodScenario);
    options.junit = folder / "j.xml";
    options.findings = folder / "f.jsonl";
    options.stats = folder / "s.stats";
  }
  int run() {
    std::ostringstream out;
    std::ostringstream err;
    const std::string list = folder / "list.csv";
    const std::string_view inputs[] = {list};
    const int code = host::run({.tables = tables.rows, .inputs = inputs}, options, out, err);
    messages = err.str();
    return code;
  }
  /// Files of a good run, one of findings with a line.
  void make_old_files() {
    REQUIRE(run() == host::kGood);
    folder.write("f.jsonl", R"({"t":1,"finding":"lost command","of":"X"})");
  }
  std::string junit() const { return read_bytes(options.junit); }
  bool are_those_of_a_failed_run(const std::string& error) const {
    return contains(junit(), "errors=\"1\"") && contains(junit(), "name=\"run\"") && contains(junit(), error) &&
           !fs::exists(options.findings) && !fs::exists(options.stats);
  }

  BenchTables tables{{"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}};
  TemporaryFolder folder;
  host::RunOptions options;
  std::string messages;
};

TEST_CASE("A run that fails before it begins leaves its error in the JUnit file, and no old file") {
  const auto listener = link::net::listen_on({"127.0.0.1", 0});
  REQUIRE(std::holds_alternative<link::net::Listener>(listener));
  const std::string port = std::to_string(std::get<link::net::Listener>(listener).bound.port);
  ResultRun result;
  result.make_old_files();
  const auto fails = [&](int code, const std::string& error) {
    CHECK(result.run() == code);
    INFO(result.messages);
    CHECK(result.are_those_of_a_failed_run(error));
    result.set_options();
    result.make_old_files();
  };
  result.options.scenario = result.folder.write("bad.json", "{");
  fails(host::kBadInput, "bad.json:1");
  result.options.scenario = result.folder / "none.json";
  fails(host::kBadInput, "cannot read the scenario");
  result.options.links = {"modbus-tcp-server://127.0.0.1:99999"};
  fails(host::kBadInput, "99999");
  result.options.links = {"modbus-tcp-server://127.0.0.1:" + port};
  fails(host::kEnvironment, "port " + port + " is in use");
  result.options.resume = result.folder / "none.json";
  fails(host::kBadInput, "none.json");
  result.options.why = {"NONE"};
  fails(host::kBadInput, "NONE");
  result.options.trace = "/no/such/folder/t";
  fails(host::kEnvironment, "/no/such/folder/t");
  result.options.panel = panel::PanelOptions{.address = port};
  fails(host::kEnvironment, "port " + port + " is in use");
  result.options.clock = host::RunOptions::Clock::plc;
  result.options.plc_clock = "NONE";
  fails(host::kBadInput, "NONE");
}

TEST_CASE("A table of an earlier run does not survive the start of a run") {
  ResultRun result;
  result.options.stats = result.folder / "use.csv";
  REQUIRE(result.run() == host::kGood);
  CHECK(contains(read_bytes(result.options.stats), "\ndevice,L_P_AGV,activity,waiting,1,100.000,"));
  CHECK_FALSE(contains(read_bytes(result.options.stats), "symplant-stats"));
  std::ostringstream out;
  const host::ResultFiles files(result.options, out);
  CHECK_FALSE(fs::exists(result.options.stats));
}

TEST_CASE("A file that an option names by mistake, and that is no result, is left as it is") {
  ResultRun result;
  const std::string list = result.folder.write("list.csv", "name\n");
  result.options.junit = list;
  CHECK(result.run() == host::kBadInput);
  CHECK(read_bytes(list) == "name\n");
  result.options.junit.clear();
  result.options.stats = list;
  CHECK(result.run() == host::kBadInput);
  CHECK(read_bytes(list) == "name\n");
}

TEST_CASE("A failed run replaces any file that is no input, not only results") {
  ResultRun run;
  for (const std::string& file : {run.options.junit, run.options.findings, run.options.stats}) {
    run.folder.write(fs::path(file).filename().string(), "old\n");
  }
  run.options.scenario = run.folder / "none.json";
  CHECK(run.run() == host::kBadInput);
  CHECK(run.are_those_of_a_failed_run("cannot read the scenario"));
}

TEST_CASE("While a run is not over, its JUnit file has an error, as for a run that is killed") {
  ResultRun result;
  std::ostringstream out;
  std::ostringstream err;
  const int code = host::with_results(result.options, "P", out, err, [&](host::ResultFiles& files) {
    CHECK(files.open("P", err));
    CHECK(contains(result.junit(), "<error message=\"the run has not ended\"/>"));
    CHECK(files.write_junit("the result").empty());
    return host::kEnvironment;
  });
  CHECK(code == host::kEnvironment);
  CHECK(result.junit() == "the result");  // a run that has ended writes its error itself
}

TEST_CASE("An exception is an error of the environment, with its text") {
  ResultRun result;
  std::ostringstream out;
  std::ostringstream err;
  const int code = host::with_results(result.options, "P", out, err,
                                      [](host::ResultFiles&) -> int { throw std::runtime_error("no memory"); });
  CHECK(code == host::kEnvironment);
  CHECK(err.str() == "error: no memory\n");
  CHECK(result.are_those_of_a_failed_run("error: no memory"));
}

TEST_CASE("Errors of a terminal lose their colors, and a failure without a message is still an error") {
  ResultRun run;
  std::ostringstream out;
  std::ostringstream err;
  const auto fails_with = [&](const std::string& message) {
    host::with_results(run.options, "P", out, err, [&](host::ResultFiles&) {
      err << message;
      return host::kBadInput;
    });
    return run.junit();
  };
  CHECK(contains(fails_with("a\n\x1B[1;31merror: \x1B[0mno list\nb\n"), "<error message=\"error: no list\"/>"));
  CHECK(contains(fails_with(""), "<error message=\"the run failed, see its messages\"/>"));
}

TEST_CASE("Statistics that cannot be written are an error in the JUnit file") {
  if (!fs::exists("/dev/full")) return;
  ResultRun result;
  result.options.stats = "/dev/full";
  CHECK(result.run() == host::kEnvironment);
  CHECK(contains(result.junit(), "<error message=\"cannot write the statistics"));
  CHECK(contains(result.junit(), "name=\"step 1: expect `L_P_AGV.P1`\" time=\"1\"/>"));
}

TEST_CASE("A JUnit file at standard output has the error of a failed run") {
  ResultRun result;
  result.options.junit = "-";
  result.options.scenario = result.folder / "none.json";
  std::ostringstream out;
  std::ostringstream err;
  CHECK(host::run({.tables = result.tables.rows}, result.options, out, err) == host::kBadInput);
  CHECK(contains(out.str(), "<error message=\"error: cannot read the scenario"));
}

}  // namespace
}  // namespace symplant::test
