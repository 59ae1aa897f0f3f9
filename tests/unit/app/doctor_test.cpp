// symplant doctor and map against a PLC.
#include <nlohmann/json.hpp>
#include <thread>

#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "support/raw_client.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "support/tool.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using test::slmp::PlcOptions;
using test::slmp::SlmpPlc;

namespace {

using Json = nlohmann::json;

constexpr const char* kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
    "VAR_GLOBAL,LINE_S1_CYL_O_OUT,Y0020,%QX32,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_O_IN,Y0021,%QX33,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_I_OUT,X0010,%IX16,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_I_IN,X0011,%IX17,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_TANK_O_LEVEL,,,INT,0,\n";

test::ToolRun doctor(std::vector<std::string> arguments) {
  test::MemoryFileSystem files;
  files.files["list.csv"] = kList;
  arguments.insert(arguments.begin(), {"doctor", "list.csv"});
  return test::run_tool(arguments, files);
}

std::string url(const SlmpPlc& plc, const std::string& parameters) {
  return "slmp://127.0.0.1:" + std::to_string(plc.port()) + "?" + parameters;
}

Json json_of(const test::ToolRun& run) {
  CAPTURE(run.err);
  return Json::parse(run.out);
}

/// The step or point with this name.
Json entry(const Json& list, const char* key, const std::string& name) {
  for (const Json& one : list) {
    if (one.at(key) == name) return one;
  }
  FAIL("no " << name);
  return {};
}

}  // namespace

TEST_CASE("The doctor reads every mapped symbol and writes nothing") {
  SlmpPlc plc;
  plc.memory().set_bit("Y", 0x21, true);
  plc.memory().set_word("D", 100, 0xFFF6);
  const auto run = doctor({"--link", url(plc, "family=iqr&events=direct&map=LINE_S1_TANK_O_LEVEL:D100"), "--format",
                           "json", "--for", "0s"});
  const Json report = json_of(run);
  CHECK(run.code == 0);
  CHECK(report.at("reached") == true);
  CHECK(report.at("findings") == false);
  CHECK_THAT(entry(report.at("steps"), "step", "identity").at("text"), ContainsSubstring("R08CPU"));
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_O_IN").at("value") == true);
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_O_OUT").at("value") == false);
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_TANK_O_LEVEL").at("value") == -10);
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_OUT").at("address") == "X10");
  CHECK(plc.log().writes().empty());
  CHECK(plc.log().violations().empty());
}

TEST_CASE("The doctor's write test restores what was there") {
  SlmpPlc plc;
  plc.memory().set_bit("X", 0x11, true);
  const auto run = doctor({"--link", url(plc, "family=iqr&events=direct&map=LINE_S1_TANK_O_LEVEL:D100"), "--format",
                           "json", "--for", "0s", "--write-test"});
  CHECK(run.code == 0);
  CHECK_THAT(entry(json_of(run).at("steps"), "step", "write test").at("text"),
             ContainsSubstring("2 events of 2 written"));
  CHECK(plc.memory().bit("X", 0x11));
  CHECK_FALSE(plc.memory().bit("X", 0x10));
  CHECK(plc.log().writes_outside({{"X", 0x10, 2}}).empty());
  CHECK_FALSE(plc.log().writes().empty());
}

TEST_CASE("The doctor finds inputs that the PLC overwrites") {
  PlcOptions options;
  options.refreshed = {{"X", 0x10, 1}};
  SlmpPlc plc(options);
  const auto run = doctor({"--link", url(plc, "family=iqr&events=direct&map=LINE_S1_TANK_O_LEVEL:D100"), "--format",
                           "json", "--for", "0s", "--write-test"});
  CHECK(run.code == 1);
  const Json report = json_of(run);
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_OUT").at("result") == "bad");
  CHECK_THAT(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_OUT").at("text"),
             ContainsSubstring("choose another strategy"));
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_IN").at("result") == "good");
}

TEST_CASE("The doctor finds events that the PLC's program writes") {
  PlcOptions options;
  options.program = [](test::slmp::PlcMemory& memory) { memory.set_bit("X", 0x11, !memory.bit("X", 0x11)); };
  SlmpPlc plc(options);
  Json point;
  for (int i = 0; i < 20 && point != "warning"; ++i) {  // two looks may find the same value
    const auto run = doctor({"--link", url(plc, "family=iqr&events=direct&map=LINE_S1_TANK_O_LEVEL:D100"), "--format",
                             "json", "--for", "300ms"});
    point = entry(json_of(run).at("points"), "symbol", "LINE_S1_CYL_I_IN").at("result");
  }
  CHECK(point == "warning");
}

TEST_CASE("The doctor says which symbols are not readable, and why") {
  SlmpPlc plc;
  plc.memory().configure("D", 50);
  const auto run =
      doctor({"--link", url(plc, "family=iqr&events=direct&map=LINE_S1_TANK_O_LEVEL:D100"), "--for", "0s"});
  CHECK(run.code == 1);
  CHECK_THAT(run.out, ContainsSubstring("4031") || ContainsSubstring("C056"));
  CHECK_THAT(run.out, ContainsSubstring("bad      operation LINE_S1_TANK_O_LEVEL at D100: not readable"));
}

TEST_CASE("The doctor names a wrong family and a silent port") {
  SlmpPlc plc;
  const auto wrong = doctor({"--link", url(plc, "family=q&events=direct"), "--for", "0s", "--write-test"});
  CHECK(wrong.code == 1);
  CHECK(plc.log().writes().empty());
  CHECK_THAT(wrong.out, ContainsSubstring("bad      identity") && ContainsSubstring("set family=iqr"));
  const auto silent =
      doctor({"--link", url(plc, "family=iqr&events=direct&code=ascii&timer=0s&timeout=200ms"), "--for", "0s"});
  CHECK(silent.code == 3);
  CHECK_THAT(silent.out, ContainsSubstring("does not answer") && ContainsSubstring("code=binary"));
}

TEST_CASE("The doctor of a Modbus client lists functions, and goes on where a server closes on function 43") {
  test::modbus::ModbusPlc plc({.abilities = {.functions = {1, 5}, .closing_functions = {43}}});
  const auto run = doctor({"--link", "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()) + "?events=coils:100",
                           "--format", "json", "--for", "0s", "--write-test"});
  const Json report = json_of(run);
  CHECK_THAT(entry(report.at("steps"), "step", "identity").at("text"), ContainsSubstring("does not identify itself"));
  CHECK_THAT(entry(report.at("steps"), "step", "write test").at("text"), ContainsSubstring("2 events of 2 written"));
  CHECK_THAT(entry(report.at("steps"), "step", "functions").at("text"),
             ContainsSubstring("15 or 5 to write coils") && ContainsSubstring("the PLC has 1, 5; it does not have 15"));
}

TEST_CASE("The doctor of a server link reports what the PLC touched") {
  test::MemoryFileSystem files;
  files.files["list.csv"] = kList;
  const std::uint16_t port = [] {
    SlmpPlc any;  // a free port
    return any.port();
  }();
  test::ToolRun run;
  std::thread tool([&] {
    run = test::run_tool({"doctor", "list.csv", "--link", "modbus-tcp-server://127.0.0.1:" + std::to_string(port),
                          "--for", "1s", "--format", "json"},
                         files);
  });
  for (bool answered = false; !answered;) {
    test::RawClient client(port);
    if (!client.connected()) continue;
    client.send({0, 1, 0, 0, 0, 6, 1, 2, 0, 16, 0, 1});   // discrete input 16: the event OUT
    client.send({0, 2, 0, 0, 0, 6, 1, 5, 0, 34, 0, 0});   // coil 34: no symbol
    client.send({0, 3, 0, 0, 0, 6, 1, 3, 255, 0, 0, 1});  // a register beyond the map
    answered = client.receive(10).size() == 10 && client.receive(12).size() == 12 && client.receive(9).size() == 9;
  }
  tool.join();
  const Json report = json_of(run);
  CHECK(run.code == 1);
  CHECK_THAT(entry(report.at("steps"), "step", "requests").at("text"),
             ContainsSubstring("1 answered with exception 2"));
  CHECK_THAT(entry(report.at("steps"), "step", "gaps").at("text"), ContainsSubstring("coils that no symbol uses: 34"));
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_OUT").at("result") == "good");
  CHECK(entry(report.at("points"), "symbol", "LINE_S1_CYL_I_IN").at("text") == "the PLC never read it");
}

TEST_CASE("Without an answer the doctor gives exit code 3, for a bad link 2") {
  CHECK(doctor({"--link", "modbus-tcp-server://127.0.0.1:0", "--for", "0s"}).code == 3);
  CHECK(doctor({"--link", "loop:"}).code == 2);
  CHECK(doctor({"--link", "slmp://127.0.0.1:5000?family=q"}).code == 2);
  CHECK(doctor({}).code == 2);
  CHECK(doctor({"--link", "loop:", "--for", "25h"}).code == 2);
}

TEST_CASE("The map of an slmp link names the devices") {
  test::MemoryFileSystem files;
  files.files["list.csv"] = kList;
  const auto run = test::run_tool(
      {"map", "list.csv", "--link", "slmp://127.0.0.1:5000?family=q&map=X10-X1F:M1000&map=LINE_S1_TANK_O_LEVEL:M5"},
      files);
  CHECK(run.code == 0);
  CHECK_THAT(run.out, ContainsSubstring("LINE_S1_CYL_I_IN") && ContainsSubstring("M1001"));
  CHECK_THAT(run.out, ContainsSubstring("not linked: LINE_S1_TANK_O_LEVEL is a number at M5"));
  CHECK_THAT(run.out, ContainsSubstring("operations: 1 request to read all"));
}
