// Links that go to a PLC, on the command line and in plant.json.
#include "support/catch.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "support/temporary_folder.hpp"
#include "support/tool.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using test::MemoryFileSystem;
using test::run_tool;
using test::slmp::SlmpPlc;

namespace {

MemoryFileSystem plant_with(const std::string& url) {
  MemoryFileSystem files;
  files.files["list.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
      "VAR_GLOBAL,LINE_S1_CYL_O_OUT,Y0020,%QX32,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_O_IN,Y0021,%QX33,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_I_OUT,X0010,%IX16,BOOL,FALSE,\n"
      "VAR_GLOBAL,LINE_S1_CYL_I_IN,X0011,%IX17,BOOL,FALSE,\n";
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "links": [{"url": ")" + url + R"("}]})";
  return files;
}

std::string slmp_url(const SlmpPlc& plc) {
  return "slmp://127.0.0.1:" + std::to_string(plc.port()) + "?family=iqr&events=direct&poll=1ms";
}

}  // namespace

TEST_CASE("check reports a link whose URL does not fit the plant, once, at the URL") {
  auto files = plant_with("slmp://127.0.0.1:5000?family=q");
  const auto unset = run_tool({"check", "plant.json"}, files);
  CHECK(unset.code == 1);
  CHECK_THAT(unset.out, ContainsSubstring("plant.json:1:60: error: `LINE_S1_CYL_I_OUT` is at X0010") &&
                            ContainsSubstring("1 error"));
  files = plant_with("slmp://127.0.0.1:5000?family=q&events=direct");
  CHECK(run_tool({"check", "plant.json"}, files).code == 0);
  files = plant_with("slmp://127.0.0.1:5000?famly=q");
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out,
             ContainsSubstring("no `family`") && ContainsSubstring("1 error"));
  files = plant_with("modbus-tcp://127.0.0.1:502");
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out, ContainsSubstring("choose where its program reads events"));
}

TEST_CASE("map shows the devices of the link in plant.json") {
  auto files = plant_with("slmp://127.0.0.1:5000?family=q&map=X0-X1F:M100");
  CHECK_THAT(run_tool({"map", "plant.json"}, files).out, ContainsSubstring("in the PLC") && ContainsSubstring("M117"));
  CHECK_THAT(run_tool({"map", "list.csv"}, files).out, ContainsSubstring("discrete input 17"));
}

TEST_CASE("run without a choice for events gives exit code 2 and explains the choice") {
  auto files = plant_with("slmp://127.0.0.1:5000?family=q&events=direct");
  const auto run = run_tool({"run", "plant.json", "--link", "slmp://127.0.0.1:5000?family=q"}, files);
  CHECK(run.code == 2);
  CHECK_THAT(run.err, ContainsSubstring("choose how events reach it"));
}

TEST_CASE("run exchanges I/O with the PLC of plant.json, and says what the link did") {
  SlmpPlc plc;
  plc.memory().set_bit("Y", 0x20, true);
  auto files = plant_with(slmp_url(plc));
  const test::TemporaryFolder folder;
  const auto run = run_tool({"run", "plant.json", "--until", "2500ms", "--stats", folder / "stats.json"}, files);
  CHECK(run.code == 0);
  CHECK_THAT(run.err, ContainsSubstring("link: connected: CPU `R08CPU`"));
  CHECK_THAT(run.out, ContainsSubstring("0 rejected, armed"));
  CHECK(plc.memory().bit("X", 0x10));  // the cylinder is out
  CHECK(plc.log().writes_outside({{"X", 0x10, 2}}).empty());
}

TEST_CASE("run warns of --arm without a link that goes to a PLC") {
  auto files = plant_with("modbus-tcp-server://127.0.0.1:0");
  CHECK_THAT(run_tool({"run", "list.csv", "--arm", "--until", "1ms"}, files).err,
             ContainsSubstring("`--arm` has no effect"));
}
