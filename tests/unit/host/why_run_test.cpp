// Explanations at the end of a run: `--why`.
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/golden.hpp"
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"

namespace symplant::test {
namespace {

/// A machine that works only while the vehicle is in P2.
struct WhyRun {
  WhyRun() : tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2"}, reported()) {
    options.why = {"L_P_MC"};
  }

  static Reported reported() {
    Reported reported;
    reported.on_command("MC", "IDLE1", "RUN2", fixed(tables::kSecond));
    reported.device("MC").transitions.back().when = "L_P_AGV.P2";
    reported.description.requirements.push_back({"still", "L_P_AGV.moving", "", "", 0});
    return reported;
  }
  int run(const std::string& steps = "") {
    if (!steps.empty()) {
      options.scenario = folder.write("s.json", R"({"symplant-scenario":1,"steps":[)" + steps + "]}");
    }
    std::ostringstream report;
    std::ostringstream messages;
    const int code = host::run({.tables = tables.rows}, options, report, messages);
    out = report.str();
    err = messages.str();
    return code;
  }

  BenchTables tables;
  TemporaryFolder folder;
  host::RunOptions options;
  std::string out;
  std::string err;
};

const std::string kStart = R"({"at":"1s","set":{"L_P_MC_O_RUN2":true}},{"at":"3s"})";

TEST_CASE("An explanation follows the summary of a run") {
  WhyRun run;
  run.options.why = {"l_p_mc", "L_P_AGV_O_P2"};
  CHECK(run.run(kStart) == host::kGood);
  CHECK(
      contains(run.out,
               "requirements: 1 held, 0 violated\n"
               "why: L_P_MC has been in IDLE1 since the start: %QX5 (operation RUN2, symbols.csv:7) has been on since "
               "1 s, but `when` needs L_P_AGV.P2\n"
               "    L_P_AGV has been in P1 since the start: %QX2 (operation P2, symbols.csv:4) has never been on (no "
               "step of the scenario sets it)\n"
               "why: L_P_AGV_O_P2 has been off since the start, PLC output %QX2, operation P2 of L_P_AGV "
               "(symbols.csv:4): no step of the scenario sets it\n"
               "    L_P_AGV has been in P1 since the start, and goes to P2 on it\n"));
}

TEST_CASE("Without a scenario and a link nothing writes an operation, and a requirement says when it was violated") {
  WhyRun run;
  CHECK(run.run() == host::kGood);
  CHECK(contains(run.out, "has never been on (no link and no scenario writes it), and `when` needs L_P_AGV.P2\n"));
  run.options.why = {"still"};
  run.run(R"({"at":"2s","set":{"L_P_AGV_O_P2":true}},{"at":"5s"})");
  CHECK(contains(run.out,
                 "why: requirement `still` is not violated now: that needs L_P_AGV.moving; it was violated at "
                 "2 s\n"));
}

TEST_CASE("A name that is not found ends the run before it begins, with the nearest name") {
  WhyRun run;
  run.options.why = {"L_P_MX", "L_P_MC", "nothing like it"};
  run.options.trace = run.folder / "trace.jsonl";
  CHECK(run.run(kStart) == host::kBadInput);
  CHECK(run.err ==
        "error: `L_P_MX` of `--why` not found; did you mean `L_P_MC`?\n"
        "error: `nothing like it` of `--why` not found; name a device, symbol, requirement, track, place, transfer, "
        "work or source\n");
  CHECK(run.out.empty());
  CHECK_FALSE(std::filesystem::exists(run.folder / "trace.jsonl"));
}

TEST_CASE("The statistics have the explanations") {
  WhyRun run;
  run.options.stats = run.folder / "stats.json";
  run.run(kStart);
  const auto why = nlohmann::json::parse(read_bytes(run.folder / "stats.json")).at("why");
  REQUIRE(why.size() == 1);
  CHECK(why[0].at("of") == "L_P_MC");
  CHECK(why[0].at("about") == nlohmann::json::parse(R"([{"device":"L_P_MC"},{"symbol":"L_P_MC_O_RUN2"}])"));
  CHECK(why[0].at("because")[0].at("about")[0].at("device") == "L_P_AGV");
  run.options.why.clear();
  run.run(kStart);
  CHECK_FALSE(nlohmann::json::parse(read_bytes(run.folder / "stats.json")).contains("why"));
}

TEST_CASE("An operation that no link carries, or whose link has no PLC yet, says so") {
  WhyRun run;
  run.options.links = {"modbus-tcp-server://127.0.0.1:0"};
  run.options.until = 20 * kMs;
  run.options.cycle = 10 * kMs;
  CHECK(run.run() == host::kGood);
  CHECK(contains(run.out, "has never been on (its link modbus-tcp-server://127.0.0.1:"));
  CHECK(contains(run.out, " still waits for its PLC), and `when` needs L_P_AGV.P2\n"));
  run.options.links = {"loop:"};
  CHECK(run.run() == host::kGood);
  CHECK(contains(run.out, "has never been on (no link carries it), and `when` needs"));
}

}  // namespace
}  // namespace symplant::test
