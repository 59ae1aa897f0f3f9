// Tests of symplant run: its first lines, its end, its exit codes.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

/// A port of this machine with a listener.
class TakenPort {
 public:
  TakenPort() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    REQUIRE(socket_ >= 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    sockaddr plain{};
    std::memcpy(&plain, &address, sizeof plain);
    REQUIRE(::bind(socket_, &plain, sizeof address) == 0);
    REQUIRE(::listen(socket_, 1) == 0);
    socklen_t size = sizeof plain;
    REQUIRE(::getsockname(socket_, &plain, &size) == 0);
    std::memcpy(&address, &plain, sizeof address);
    port_ = ntohs(address.sin_port);
  }
  ~TakenPort() { ::close(socket_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  std::string url() const { return "modbus-tcp-server://127.0.0.1:" + std::to_string(port_); }

 private:
  int socket_;
  unsigned port_ = 0;
};

TEST_CASE("run: --why may be repeated, takes one name each, and may be before or after the plant") {
  test::MemoryFileSystem files;
  files.files["l.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,L_P_D_O_A1,,%QX0,BOOL,\n"
      "VAR_GLOBAL,L_P_D_I_A1,,%IX0,BOOL,\nVAR_GLOBAL,L_P_D_O_B2,,%QX1,BOOL,\nVAR_GLOBAL,L_P_D_I_B2,,%IX1,BOOL,\n";
  const test::ToolRun run = test::run_tool({"run", "--why", "L_P_D_I_B2", "l.csv", "--why", "L_P_D"}, files);
  CHECK(run.code == 0);
  CHECK(test::contains(run.out,
                       "\nwhy: L_P_D_I_B2 has been off since the start, PLC input %IX1, event B2 of L_P_D "
                       "(l.csv:5)\n    L_P_D has been in A1 since the start: %QX1 (operation B2, l.csv:4) has "
                       "never been on (no link and no scenario writes it)\nwhy: L_P_D has been in A1 since"));
  CHECK(test::run_tool({"run", "l.csv", "--why", "L_P_E"}, files).code == 2);
}

TEST_CASE("run: A finding that plant.json expects does not fail the run") {
  test::MemoryFileSystem files;
  files.files["l.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,L_P_D_O_A1,,%QX0,BOOL,\n"
      "VAR_GLOBAL,L_P_D_I_A1,,%IX0,BOOL,\nVAR_GLOBAL,L_P_D_O_B2,,%QX1,BOOL,\nVAR_GLOBAL,L_P_D_I_B2,,%IX1,BOOL,\n";
  const test::TemporaryFolder folder;
  const std::string scenario = folder.write(
      "s.json",
      R"({"symplant-scenario":1,"steps":[{"at":"1s","set":{"L_P_D_O_A1":true,"L_P_D_O_B2":true}},{"at":"3s"}]})");
  const auto run = [&](const std::string& ignore) {
    files.files["plant.json"] = R"({"symplant": 1, "symbols": ["l.csv"], "check": { "ignore": [)" + ignore + "]}}";
    return test::run_tool({"run", "plant.json", "--scenario", scenario, "--fail-on-findings"}, files);
  };
  CHECK(run("").code == 1);
  const std::string both = R"({ "finding": "conflicting operations", "of": "L_P_*", "why": "tested")";
  const test::ToolRun ignored = run(both + "}");
  CHECK(ignored.code == 0);
  CHECK(test::contains(ignored.out, "findings: 1 ignored, as plant.json says"));
  CHECK(run(both + R"(, "until": "2020-01-01"})").code == 1);
  const test::ToolRun date = run(both + R"(, "until": "soon"})");
  CHECK(date.code == 2);
  CHECK(test::contains(date.err, "`soon` is not a date"));
  const test::ToolRun unknown = run(R"({ "finding": "conflict", "why": "x" })");
  CHECK(unknown.code == 2);
  CHECK(test::contains(unknown.err, "plant.json:1:"));
  CHECK(run(R"({ "finding": "requirement violated", "why": "x" })").code == 2);
}

TEST_CASE("run: The first lines report the input, what can move and what no device drives") {
  MemoryFileSystem files = lists();
  files.files["list.csv"] = list_text({{"L_P_D_O_A1", "Y1"},
                                       {"L_P_D_I_A1", "X1"},
                                       {"L_P_D_I_B2", "X2"},
                                       {"START", "X3"},
                                       {"L_P_E_I_ON", "X4"},
                                       {"TEMP", "D100", "INT", "0"}});
  const ToolRun run = run_tool({"run", "list.csv"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "5 I/O symbols from list.csv (1 operation, 4 events)"));
  CHECK(contains(run.out, "internal: 1 rows (1 memory addresses)"));
  CHECK(contains(run.out, "can move: 1 of 2 devices, using 1 of 1 operation"));
  CHECK(contains(run.out, "not driven: 2 of 4 events: START, L_P_E_I_ON"));
  CHECK(contains(run.out, "in no device: 1 "));
}

TEST_CASE("run: Virtual time ends when nothing is due, with a message") {
  const ToolRun run = run_lists({"run", "excell.csv"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "ended at 0 s: nothing more will happen"));
}

TEST_CASE("run --until: The run ends at that time") {
  CHECK(contains(run_lists({"run", "excell.csv", "--until", "2500ms"}).out, "ended at 2.5 s"));
}

TEST_CASE("run: A plant that never rests ends after an hour of plant time, with a note") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"L_P_D_O_A1", "L_P_D_I_B2", "L_P_D_I_C3", "L_P_D_I_A1*"}));
  // B2 and C3 follow automatically; A1 has an operation, so C3 is the end.
  CHECK(contains(run_tool({"run", "list.csv"}, files).out, "ended at 2 s: nothing more will happen"));
}

TEST_CASE("run: Errors and unreadable lists give exit code 2, a warning 0") {
  CHECK(run_lists({"run", "warning.csv"}).code == 0);
  CHECK(run_lists({"run", "error.csv"}).code == 2);
  for (const std::string& list : kUnreadable) CHECK(run_lists({"run", list}).code == 2);
}

TEST_CASE("run: Virtual time with a link to a PLC is rejected, with loop: it is accepted") {
  const ToolRun refused = run_lists({"run", "excell.csv", "--clock", "virtual", "--link", TakenPort().url()});
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "virtual"));
  CHECK(run_lists({"run", "excell.csv", "--clock", "virtual", "--link", "loop:"}).code == 0);
  CHECK(run_lists({"run", "excell.csv", "--link", "loop:"}).code == 0);
}

TEST_CASE("run: A port in use gives exit code 3 and a message") {
  const TakenPort taken;
  const ToolRun run = run_lists({"run", "excell.csv", "--link", taken.url()});
  CHECK(run.code == 3);
  CHECK(contains(run.err, "in use"));
}

TEST_CASE("run --trace: A header comes first, then a line for each change") {
  const TemporaryFolder folder;
  CHECK(run_lists({"run", "excell.csv", "--until", "1s", "--trace", folder / "trace.jsonl", "--seed", "7"}).code == 0);
  const std::string text = read_bytes(folder / "trace.jsonl");
  CHECK(contains(text, "{\"symplant-trace\":1,\"plant\":\"excell\",\"model_hash\":\""));
  CHECK(contains(text,
                 "\"seed\":7,\"clock\":\"virtual\"}\n{\"t\":0,\"symbol\":\"EXLINE_MB_AGV_I_P1\",\"value\":true}\n"
                 "{\"t\":0,\"symbol\":\"EXLINE_MB_MC_I_IDLE1\",\"value\":true}\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("run: An unwritable trace gives exit code 3") {
  const TemporaryFolder folder;
  const ToolRun run = run_lists({"run", "excell.csv", "--trace", folder / "none/trace.jsonl"});
  CHECK(run.code == 3);
  CHECK(contains(run.err, "none/trace.jsonl"));
}

}  // namespace
}  // namespace symplant::test
