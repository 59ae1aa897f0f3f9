// symplant record: usage, and a recording of a PLC, in process.
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "support/temporary_folder.hpp"
#include "support/tool.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using test::MemoryFileSystem;
using test::ToolRun;
using test::modbus::ModbusPlc;
using test::modbus::PlcMemory;

namespace {

constexpr const char* kPlant =
    R"({"symplant": 1, "symbols": ["list.csv"], "links": [{"url": "modbus-tcp-server://:1502"}],
  "values": {"level": {"start": 0, "min": 0, "max": 100, "integral": "LINE_S1_CYL.OUT"}}})";

ToolRun record(std::vector<std::string> arguments) {
  MemoryFileSystem files;
  files.files["list.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
      "VAR_GLOBAL,LINE_S1_CYL_O_OUT,Y0020,%QX32,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_O_IN,Y0021,%QX33,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_I_OUT,X0010,%IX16,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_I_IN,X0011,%IX17,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_TANK_O_LEVEL,,,INT,0,\n";
  files.files["plant.json"] = kPlant;
  arguments.insert(arguments.begin(), "record");
  return test::run_tool(arguments, files);
}

constexpr const char* kUrl = "modbus-tcp://127.0.0.1:1";

/// What a command line that is refused says.
std::string refused(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "list.csv");
  const ToolRun run = record(arguments);
  CHECK(run.code == 2);
  CHECK(run.out.empty());
  return run.err;
}

}  // namespace

TEST_CASE("record refuses links that cannot be read, and more than one") {
  CHECK_THAT(refused({"--link", "loop:"}), ContainsSubstring("`loop:` is not a link to a PLC that can be read"));
  CHECK_THAT(refused({"--link", "modbus-tcp-server://:1502"}),
             ContainsSubstring("is not a link to a PLC that can be read"));
  CHECK_THAT(refused({"--link", "telnet://a"}), ContainsSubstring("`telnet://a` is not a link"));
  CHECK_THAT(refused({"--link", "modbus-tcp://127.0.0.1:502?evnts=coils"}), ContainsSubstring("evnts"));
  CHECK_THAT(refused({}), ContainsSubstring("the plant has no link: give `--link URL`"));
  CHECK_THAT(refused({"--link", kUrl, "--link", kUrl}), ContainsSubstring("run one `record` for each PLC"));
  CHECK_THAT(refused({"--link", std::string("PLC9=") + kUrl}), ContainsSubstring("controller `PLC9` not found"));
  const ToolRun own = record({"plant.json"});
  CHECK(own.code == 2);
  CHECK_THAT(own.err, ContainsSubstring("`modbus-tcp-server://:1502` is not a link to a PLC that can be read"));
}

TEST_CASE("record refuses options that make no sense") {
  CHECK_THAT(refused({"--link", kUrl, "--before", "10s"}), ContainsSubstring("--before requires --start-when"));
  CHECK_THAT(refused({"--link", kUrl, "--trace-limit", "1M"}), ContainsSubstring("--trace-limit requires --output"));
  CHECK_THAT(refused({"--link", kUrl, "-o", "x", "--trace-limit", "1"}), ContainsSubstring("1k or more"));
  CHECK_THAT(refused({"--link", kUrl, "--every", "1us"}), ContainsSubstring("from 1ms to 1h"));
  CHECK_THAT(refused({"--link", kUrl, "--until", "0s"}), ContainsSubstring("above 0"));
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", "Tag,Address,Type\nLINE_S1_CYL_O_OUT,%QX0,BOOL\n");
  base::DiskFileSystem files;
  const ToolRun run = test::run_tool({"record", list, "--link", kUrl, "-o", list}, files);
  CHECK(run.code == 2);
  CHECK_THAT(run.err, ContainsSubstring("is an input"));
  const ToolRun part = test::run_tool({"record", folder.write("x.1", "Tag,Address,Type\nLINE_S1_CYL_O_OUT,%QX0,BOOL\n"),
                                       "--link", kUrl, "-o", folder / "x", "--trace-limit", "1k"},
                                      files);
  CHECK(part.code == 2);
  CHECK_THAT(part.err, ContainsSubstring("is an input"));
}

TEST_CASE("Conditions of a recording name symbols only") {
  CHECK_THAT(refused({"--link", kUrl, "--start-when", "LINE_S1_CYL.OUT"}),
             ContainsSubstring("--start-when `LINE_S1_CYL.OUT`: it names a state of the device `LINE_S1_CYL`"));
  CHECK_THAT(refused({"--link", kUrl, "--stop-when", "LINE_S1_CYL.moving"}),
             ContainsSubstring("--stop-when") && ContainsSubstring("not read from a PLC"));
  CHECK_THAT(refused({"--link", kUrl, "--start-when", "LINE_S1_CYL_I_OU"}),
             ContainsSubstring("did you mean `LINE_S1_CYL_I_OUT`?"));
  CHECK_THAT(refused({"--link", kUrl, "--start-when", "LINE_S1_TANK_O_LEVEL > 3"}),
             ContainsSubstring("this link does not read `LINE_S1_TANK_O_LEVEL`"));
  const ToolRun value = record({"plant.json", "--link", kUrl, "--start-when", "level > 3"});
  CAPTURE(value.err);
  CHECK(value.code == 2);
  CHECK_THAT(value.err, ContainsSubstring("it names the value `level`"));
}

TEST_CASE("record writes to standard output, and its messages elsewhere") {
  ModbusPlc plc;
  plc.with([](PlcMemory& memory) { memory.discrete_inputs[17] = 1; });
  const std::string url = "modbus-tcp://127.0.0.1:" + std::to_string(plc.port());
  const ToolRun run = record({"list.csv", "--link", url, "--until", "200ms", "--every", "20ms"});
  CHECK(run.code == 0);
  CHECK_THAT(run.out, Catch::Matchers::StartsWith("{\"symplant-trace\":1,") &&
                          ContainsSubstring("\"symbol\":\"LINE_S1_CYL_I_IN\",\"value\":true}") &&
                          Catch::Matchers::EndsWith("{\"t\":200000000,\"end\":true}\n"));
  CHECK_THAT(run.err, ContainsSubstring("link: connected: the PLC is `Test PLC`") &&
                          ContainsSubstring("`LINE_S1_TANK_O_LEVEL` has no address") &&
                          ContainsSubstring("recorded 0.2 s: 0 changes of 4 symbols") &&
                          ContainsSubstring("resolution: "));
  CHECK(plc.written().empty());
}

TEST_CASE("A recording is compared like a trace, and cannot be replayed") {
  ModbusPlc plc;
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", "Tag,Address,Type\nLINE_S1_CYL_O_OUT,%QX0,BOOL\n");
  const std::string url = "modbus-tcp://127.0.0.1:" + std::to_string(plc.port());
  base::DiskFileSystem files;
  const std::string path = folder / "r.jsonl";
  CHECK(test::run_tool({"record", list, "--link", url, "--until", "100ms", "-o", path}, files).code == 0);
  CHECK(test::run_tool({"compare", path, path}, files).code == 0);
  const ToolRun replay = test::run_tool({"run", list, "--replay", path}, files);
  CHECK(replay.code == 2);
  CHECK_THAT(replay.err, ContainsSubstring("this is a recording of a real plant"));
}

TEST_CASE("An older file is kept until a recording starts") {
  ModbusPlc plc;
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", "Tag,Address,Type\nLINE_S1_CYL_O_OUT,%QX0,BOOL\n");
  const std::string path = folder.write("r.jsonl", "old\n");
  base::DiskFileSystem files;
  const std::string url = "modbus-tcp://127.0.0.1:" + std::to_string(plc.port());
  CHECK(test::run_tool({"record", list, "--link", kUrl, "--until", "100ms", "-o", path}, files).code == 3);
  CHECK(test::read_bytes(path) == "old\n");
  CHECK(test::run_tool({"record", list, "--link", url, "--until", "100ms", "-o", path}, files).code == 0);
  CHECK_THAT(test::read_bytes(path), Catch::Matchers::StartsWith("{\"symplant-trace\":1,"));
}

TEST_CASE("A PLC that does not answer gives exit code 3") {
  const ToolRun run = record({"list.csv", "--link", kUrl, "--until", "100ms"});
  CHECK(run.code == 3);
  CHECK(run.out.empty());
  CHECK_THAT(run.err, ContainsSubstring("no connection to 127.0.0.1:1") &&
                          ContainsSubstring("error: nothing was recorded: there was no complete reading of the PLC"));
}

TEST_CASE("A file that cannot be opened gives exit code 3 before the PLC is asked") {
  const ToolRun run = record({"list.csv", "--link", kUrl, "-o", "/no/such/folder/r.jsonl"});
  CHECK(run.code == 3);
  CHECK_THAT(run.err, ContainsSubstring("error: cannot write the recording `/no/such/folder/r.jsonl`: No such file"));
}
