// Runs with links: whether a PLC has come, and whether plant time has run.
#include <array>
#include <sstream>

#include "support/golden.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/report.hpp"
#include "symplant/host/run.hpp"
#include "symplant/link/net/listener.hpp"

namespace symplant::test {
namespace {

constexpr const char* kAnyPort = "modbus-tcp-server://127.0.0.1:0";

struct LinkOutcome {
  int code;
  std::string out;
  std::string err;
};

/// A vehicle with a link, for 50 ms, and a folder for files.
struct LinkedRun {
  explicit LinkedRun(const std::string& link) {
    options.links = {link};
    options.until = 50 * kMs;
  }
  LinkOutcome run() const {
    std::ostringstream out;
    std::ostringstream err;
    const int code =
        host::run({.tables = tables.rows, .link_settings = settings, .ignored = ignored}, options, out, err);
    return {code, out.str(), err.str()};
  }
  std::string junit() const { return read_bytes(folder / "j.xml"); }

  BenchTables tables{{"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}};
  std::array<link::LinkSettings, 1> settings{};
  std::vector<host::IgnoredFinding> ignored;
  TemporaryFolder folder;
  host::RunOptions options;
};

/// A port that accepts connections and never answers.
class SilentPort {
 public:
  SilentPort() : listener_(link::net::listen_on({"127.0.0.1", 0})) {
    REQUIRE(std::holds_alternative<link::net::Listener>(listener_));
  }
  std::string url() const {
    return "modbus-tcp://127.0.0.1:" + std::to_string(std::get<link::net::Listener>(listener_).bound.port) +
           "?events=coils:800";
  }

 private:
  std::variant<link::net::Listener, link::LinkError> listener_;
};

TEST_CASE("A run whose link no PLC uses warns and gives 0, as a test it fails") {
  LinkedRun plant(kAnyPort);
  const LinkOutcome plain = plant.run();
  CHECK(plain.code == host::kGood);
  CHECK(contains(plain.err, "warning: 0.05 s: no PLC: modbus-tcp-server://127.0.0.1:"));
  CHECK(contains(plain.err, "no valid request for a mapped address has arrived; check"));
  CHECK(contains(plain.out, "findings: no PLC (1)\n"));

  plant.options.fail_on_findings = true;
  CHECK(plant.run().code == host::kFindings);
  plant.options.fail_on_findings = false;
  plant.options.scenario = plant.folder.write("s.json", R"({"symplant-scenario":1,"steps":[{"at":"10ms"}]})");
  CHECK(plant.run().code == host::kFindings);
  plant.options.scenario.clear();
  plant.options.junit = plant.folder / "j.xml";
  plant.options.findings = plant.folder / "f.jsonl";
  CHECK(plant.run().code == host::kFindings);
  CHECK(contains(plant.junit(), "name=\"no PLC\" time=\"0.05\">\n      <failure message=\"no PLC: modbus-tcp-server"));
  CHECK(contains(plant.junit(), "name=\"plant time\" time=\"0.05\"/>"));
  CHECK(contains(read_bytes(plant.folder / "f.jsonl"), R"("finding":"no PLC","of":"modbus-tcp-server)"));
}

TEST_CASE("No PLC is ignored as plant.json says, and a loop needs no PLC") {
  LinkedRun plant(kAnyPort);
  plant.options.junit = plant.folder / "j.xml";
  plant.ignored = {{"no PLC", "", ""}};
  const LinkOutcome ignored = plant.run();
  CHECK(ignored.code == host::kGood);
  CHECK(ignored.err.empty());
  CHECK(contains(plant.junit(), "name=\"no PLC\" time=\"0.05\"/>"));

  LinkedRun loop("loop:");
  loop.options.clock = host::RunOptions::Clock::real_time;
  loop.options.junit = loop.folder / "j.xml";
  CHECK(loop.run().code == host::kGood);
  CHECK_FALSE(contains(loop.junit(), "no PLC"));
}

TEST_CASE("A link that goes to a PLC and never connects gives 3, also as a test") {
  std::string url;
  {
    const SilentPort closed_again;
    url = closed_again.url();
  }
  LinkedRun plant(url);
  const LinkOutcome plain = plant.run();
  CHECK(plain.code == host::kEnvironment);
  CHECK(contains(plain.err, "error: link modbus-tcp://127.0.0.1:"));
  CHECK(contains(plain.err, "never had a connection to its PLC, the PLC has answered no request; check"));
  plant.options.junit = plant.folder / "j.xml";
  plant.ignored = {{"no PLC", "", ""}};  // an error is no finding
  CHECK(plant.run().code == host::kEnvironment);
  CHECK(contains(plant.junit(), "errors=\"1\""));
  CHECK(contains(plant.junit(), "name=\"run\" time=\"0.05\">\n      <error message=\"link modbus-tcp"));
}

TEST_CASE("A link that connects and gets no answer has no PLC") {
  const SilentPort silent;
  LinkedRun plant(silent.url());
  plant.options.until = 500 * kMs;
  plant.options.junit = plant.folder / "j.xml";
  const LinkOutcome outcome = plant.run();
  CHECK(outcome.code == host::kFindings);
  CHECK(contains(outcome.err, "the PLC has answered no request"));
  CHECK_FALSE(contains(outcome.err, "never had a connection"));
}

TEST_CASE("A link with a PLC passes") {
  modbus::ModbusPlc plc;
  LinkedRun plant("modbus-tcp://127.0.0.1:" + std::to_string(plc.port()) + "?events=coils:800");
  plant.options.until = 3 * tables::kSecond;
  plant.options.junit = plant.folder / "j.xml";
  const LinkOutcome outcome = plant.run();
  INFO(outcome.err);
  CHECK(outcome.code == host::kGood);
  CHECK(contains(plant.junit(), "failures=\"0\" errors=\"0\""));
}

TEST_CASE("The requested end ends a plant that is frozen until its PLC comes, and the run has failed") {
  LinkedRun plant(kAnyPort);
  plant.settings[0].plant_on_loss = link::PlantOnLoss::freeze;
  plant.options.junit = plant.folder / "j.xml";
  const LinkOutcome outcome = plant.run();
  CHECK(outcome.code == host::kFindings);
  CHECK(contains(outcome.out, "ended at 0 s"));
  CHECK(contains(outcome.err, "warning: the plant is frozen, since link modbus-tcp-server"));
  CHECK(contains(outcome.err, "warning: no PLC for 5 s: link modbus-tcp-server"));
  CHECK(contains(outcome.err, "error: plant time waited at 0 s, since link modbus-tcp-server"));
  CHECK(contains(plant.junit(), "name=\"plant time\" time=\"0\">\n      <failure message=\"plant time waited at 0 s"));
}

/// What a run reports of its findings, on the terminal.
struct Reporting {
  std::size_t lines(const std::string& text) const {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = err.str().find(text, at)) != std::string::npos; ++at) ++count;
    return count;
  }

  BenchTables tables{{"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}};
  trace::PlantNames names{tables.rows};
  trace::History history{names};
  why::Explainer explainer{names, {}};
  std::ostringstream out;
  std::ostringstream err;
  host::Console console{out, err};
  host::Report report{explainer, history, nullptr, nullptr, "", {}, console};
};

TEST_CASE("Every loss of a link is on the terminal: five lines, then the number of the others") {
  Reporting run;
  run.names.name_links({{"URL", "it is silent", "it is absent"}});
  for (tables::Time time = 1; time <= 7; ++time) {
    run.report.found({time * tables::kSecond, tables::FindingKind::link_lost, {0}});
    run.report.found({time * tables::kSecond, tables::FindingKind::link_back, {0}});
  }
  CHECK(run.lines("link lost: URL, it is silent") == 5);
  CHECK(run.lines("link back: URL, what") == 5);
  run.report.report_hidden(false);
  CHECK(run.lines("not shown") == 0);
  run.report.report_hidden(true);
  CHECK(run.lines("warning: link lost: URL, 2 more within 10 s, not shown\n") == 1);
  CHECK(run.lines("note: link back: URL, 2 more within 10 s, not shown\n") == 1);
}

TEST_CASE("All findings count, notes and lost ones included") {
  Reporting run;
  run.report.found({0, tables::FindingKind::link_back, {0}});
  CHECK(run.report.findings() == 1);
  const plant::OwnedPlant plant(run.tables.rows);
  run.report.sum_up(plant, {}, 3, run.out);
  CHECK(run.report.findings() == 4);
}

TEST_CASE("A link that carries no symbol, or a tenth less than all, is a warning with the first symbol and why") {
  const auto warning = [](std::size_t with, std::size_t without) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < with + without; ++i) names.push_back("L_P_D" + std::to_string(i) + "_I_ON");
    std::vector<Row> rows = bits(names);
    for (std::size_t i = with; i < rows.size(); ++i) rows[i].iec.clear();
    const BenchTables tables(Reported{}, rows);
    host::RunOptions options;
    options.links = {kAnyPort};
    options.until = 10 * kMs;
    std::ostringstream out;
    std::ostringstream err;
    host::run({.tables = tables.rows}, options, out, err);
    const std::size_t begin = err.str().find("carries");
    return begin == std::string::npos ? "" : err.str().substr(begin, err.str().find('\n', begin) - begin);
  };
  CHECK(warning(0, 4) ==
        "carries 0 of 4 I/O symbols: `L_P_D0_I_ON` has no address, and 3 more are left out; `symplant map` lists all "
        "symbols");
  CHECK(warning(9, 1) == "carries 9 of 10 I/O symbols: `L_P_D9_I_ON` has no address; `symplant map` lists all symbols");
  CHECK(warning(10, 1).empty());
}

}  // namespace
}  // namespace symplant::test
