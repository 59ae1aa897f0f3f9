// `links` of plant.json through the whole tool: output of map, run and generate.
#include "unit/app/app_support.hpp"

namespace symplant::test {
namespace {

MemoryFileSystem plant(const std::string& link) {
  MemoryFileSystem files;
  files.files["l.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
      "VAR_GLOBAL,L_P_D_O_A,Y1,,BOOL,FALSE\n"
      "VAR_GLOBAL,L_P_D_I_A,X1,,BOOL,FALSE\n"
      "VAR_GLOBAL,SPEED,,%QD5,DINT,0\n"
      "VAR_GLOBAL,LEVEL,,%IL2,LREAL,0\n";
  files.files["plant.json"] =
      R"({"symplant": 1, "symbols": ["l.csv"], "links": [{"url": "loop:")" + (link.empty() ? "" : ", " + link) + "}]}";
  return files;
}

std::string map_of(const std::string& link, const std::vector<std::string>& more = {}) {
  MemoryFileSystem files = plant(link);
  std::vector<std::string> words{"map", "plant.json"};
  words.insert(words.end(), more.begin(), more.end());
  return run_tool(words, files).out;
}

TEST_CASE("map: Registers are shown from first to last, with word order and totals") {
  const std::string out = map_of(R"("map": [{"symbol": "SPEED", "number": 7, "word-order": "high-first"}])");
  CHECK(contains(out, "holding registers 7-8  40008-40009  high word first  the PLC    -"));
  CHECK(contains(out, "input registers 8-11   30009-30012  low word first   -"));
  CHECK(contains(out, "word order: low word first\n"));
  CHECK(contains(out, "status block: input registers 100-111\n  100  layout: version of this layout: 1\n"));
  CHECK(contains(out, "  108-111  map hash: digest of this map\n"));
  CHECK(contains(out, "lost after 1 s without a request: operations hold, the plant runs on\n"));
  CHECK_FALSE(contains(out, "watchdog"));
  CHECK_FALSE(contains(out, "on loss"));
}

TEST_CASE("map: Sizes, watchdog and policies are those of the description") {
  const std::string out = map_of(R"("status": 20, "watchdog": {"register": 3, "within": "2s"}, "on-loss": "zero",
    "plant-on-loss": "freeze", "resync": "5s", "size": {"coils": 40},
    "map": [{"symbol": "SPEED", "on-loss": "hold"}])");
  CHECK(contains(out, "coils: size 40\n"));
  CHECK(contains(out, "input registers: size 32\n"));
  CHECK(contains(out, "status block: input registers 20-31\n"));
  CHECK(contains(out, "watchdog: holding register 3\n"));
  CHECK(contains(
      out, "lost after 2 s without a change of the watchdog: operations hold, 1 of 2 go to zero, the plant freezes\n"));
  CHECK(contains(out, "after a loss: writes are collected for at most 5 s before they take effect\n"));
  CHECK(contains(out, "on loss"));
  CHECK(contains(map_of(R"("status": "off")"), "status block: off\n"));
  CHECK(contains(map_of(R"("size": {"input-registers": 32})"),
                 "status block: off, there is no room for it above the map\n"));
  CHECK(contains(map_of(R"("on-loss": "zero")"), "operations go to zero, "));
}

TEST_CASE("map --link: The map of that link's controller is shown, or the reason why it has no map") {
  CHECK(map_of(R"("status": 20)", {"--link", "modbus-tcp-server://:1502"}) == map_of(R"("status": 20)"));
  MemoryFileSystem files = plant(R"("status": 20)");
  const ToolRun loop = run_tool({"map", "plant.json", "--link", "loop:"}, files);
  CHECK(loop.code == 2);
  CHECK(contains(loop.err, "`loop:` carries symbols by name, it has no map of addresses"));
  const ToolRun other = run_tool({"map", "plant.json", "--link", "modbus:"}, files);
  CHECK(other.code == 2);
  CHECK(contains(other.err, "`modbus:` is not a link: give one of `loop:`, `modbus-tcp-server://HOST:PORT`"));
  const ToolRun unknown = run_tool({"map", "plant.json", "--link", "PLC9=modbus-tcp-server://:1502"}, files);
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "controller `PLC9` not found; "));
}

TEST_CASE("Every command rejects a plant whose symbols overlap on a link") {
  MemoryFileSystem files = plant(R"("map": [{"symbol": "LEVEL", "number": 98}], "status": 101)");
  for (const char* command : {"map", "run", "model"}) {
    const ToolRun run = run_tool({command, "plant.json"}, files);
    CHECK(run.code == 2);
    CHECK(
        contains(run.err, "the status block from input register 101 on overlaps `LEVEL` on input registers 98 to 101"));
  }
  CHECK(run_tool({"check", "plant.json"}, files).code == 1);
}

TEST_CASE("run: Settings apply to a link for every URL of the command line, and --on-loss overrides them") {
  MemoryFileSystem files = plant(R"("plant-on-loss": "run", "loss-after": "2s", "on-loss": "zero")");
  const std::vector<std::string> words{"run",     "plant.json", "--link", "modbus-tcp-server://127.0.0.1:0",
                                       "--until", "20ms"};
  CHECK(contains(run_tool(words, files).out, "after 2 s without a request: operations go to zero, the plant runs on"));
  std::vector<std::string> held = words;
  held.insert(held.end(), {"--on-loss", "hold"});
  CHECK(contains(run_tool(held, files).out, "after 2 s without a request: operations hold, the plant runs on"));
  held.back() = "keep";
  const ToolRun wrong = run_tool(held, files);
  CHECK(wrong.code == 2);
  CHECK(contains(wrong.err, "`keep` is not a policy: write hold or zero"));
}

TEST_CASE("run: The line of a link counts the operations that go to zero as map does") {
  for (const auto& [link, symbols, words] :
       {std::array{"zero", "hold", "hold, the"}, {"hold", "zero", "go to zero, the"}}) {
    const std::string text =
        std::string("\"on-loss\": \"") + link + R"(", "map": [{"symbol": "*", "on-loss": ")" + symbols;
    MemoryFileSystem files = plant(text + "\"}]");
    CHECK(contains(
        run_tool({"run", "plant.json", "--link", "modbus-tcp-server://127.0.0.1:0", "--until", "20ms"}, files).out,
        std::string("after 1 s without a request: operations ") + words));
    CHECK(contains(map_of(text + "\"}]"), std::string("operations ") + words));
  }
  MemoryFileSystem files = plant(R"("map": [{"symbol": "SPEED", "on-loss": "zero"}])");
  CHECK(contains(
      run_tool({"run", "plant.json", "--link", "modbus-tcp-server://127.0.0.1:0", "--until", "20ms"}, files).out,
      "operations hold, 1 of 2 go to zero, the plant runs on"));
}

TEST_CASE("check: An invalid URL, and a port of two links, are reported at their location") {
  const auto reported = [](const std::string& links) {
    MemoryFileSystem files = plant("");
    files.files["m.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,A_B_C_I_D,X1,,BOOL,FALSE\n";
    files.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "l.csv", "controller": "A"},
      {"file": "m.csv", "controller": "B"}], "links": [
)" + links + "]}";
    const ToolRun run = run_tool({"check", "--select", "SP6", "plant.json"}, files);
    CHECK(run.code == (run.out.find("error") == std::string::npos ? 0 : 1));
    return run.out;
  };
  const auto url = [&](const std::string& text) { return reported(R"({"controller": "A", "url": ")" + text + "\"}"); };
  CHECK(contains(url("modbus-tcp-server://127.0.0.1:99999"),
                 "plant.json:3:28: error: `127.0.0.1:99999` does not end in a port"));
  CHECK(contains(url("modbus-tcp-server://127.0.0.1"), "has no port: give HOST:PORT"));
  CHECK(contains(url("modbus-tcp-server:127.0.0.1:1"), "is not an address: give //HOST:PORT"));
  CHECK(contains(url("foo://x"), "`foo://x` is not a link: give one of `loop:`, `modbus-tcp-server://HOST:PORT`"));
  CHECK(contains(url("loop:x"), "`loop:` takes nothing after the colon"));
  CHECK_FALSE(contains(url("modbus-tcp-server://some.host:1502"), "error"));
  const std::string one = R"({"controller": "A", "url": "modbus-tcp-server://:1502"},)";
  CHECK(contains(reported(one + "\n" + R"({"controller": "B", "url": "modbus-tcp-server://:1502"})"),
                 "plant.json:4:28: error: another link already has this port: give each link a different port"));
  CHECK_FALSE(contains(reported(one + R"({"controller": "B", "url": "modbus-tcp-server://:1503"})"), "error"));
}

TEST_CASE("check: A bit beyond 7 of a byte is reported whatever the share of such addresses") {
  const auto findings = [](const std::vector<std::string>& addresses) {
    MemoryFileSystem files;
    files.files["l.csv"] = "Name,Address,Type\n";
    for (std::size_t i = 0; i < addresses.size(); ++i)
      files.files["l.csv"] += "L_P_D_I_A" + std::to_string(i) + "," + addresses[i] + ",BOOL\n";
    return run_tool({"check", "l.csv", "--select", "SP317"}, files).out;
  };
  CHECK(contains(findings({"%I0.9", "%I0.12", "%I0.1"}),
                 "`%I0.9` has no number on a link, because a byte has no bit 9;"));
  CHECK(contains(findings({"%I0.9"}), "a byte has no bit 9;"));
  CHECK_FALSE(contains(findings({"%I0.7", "%I0.1"}), "SP317"));
  CHECK_FALSE(contains(findings({"%IX1.2.3", "%IX1.2.4"}), "SP317"));  // packed as a whole
}

TEST_CASE("check: An address without a number is reported unless its symbol has a number in links") {
  const auto reported = [](const std::string& members) {
    MemoryFileSystem files = plant(members);
    files.files["l.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
    for (const std::string bit : {"1.0", "1.8", "2.0", "2.1"}) {
      files.files["l.csv"] +=
          "VAR_GLOBAL,L_P_D_I_A" + bit.substr(0, 1) + bit.substr(2) + ",,%IX" + bit + ",BOOL,FALSE\n";
    }
    return run_tool({"check", "plant.json", "--select", "SP317"}, files).out;
  };
  CHECK(contains(
      reported(""),
      "`%IX1.8` has no number on a link, because a byte has no bit 8; so 3 other discrete inputs are in list order"));
  CHECK_FALSE(contains(reported(R"("map": [{"symbol": "L_P_D_I_A18", "number": 70}])"), "SP317"));
}

TEST_CASE("run: A timeout shorter than the cycle allows gives a warning with the key that sets it") {
  const auto warned = [](const std::string& members, const std::string& cycle) {
    MemoryFileSystem files = plant(members);
    return run_tool(
               {"run", "plant.json", "--link", "modbus-tcp-server://127.0.0.1:0", "--until", "5ms", "--cycle", cycle},
               files)
        .err;
  };
  CHECK(contains(warned(R"("loss-after": "4ms")", "2ms"),
                 "`loss-after` of 0.004 s is not longer than two cycles of 0.002 s"));
  CHECK_FALSE(contains(warned(R"("loss-after": "5ms")", "2ms"), "two cycles"));
  const std::string watchdog = R"("loss-after": "1ms", "watchdog": {"register": 20, "within": )";
  CHECK(contains(warned(watchdog + "\"3ms\"}", "2ms"), "`within` of 0.003 s is not longer"));
  CHECK_FALSE(contains(warned(watchdog + "\"1s\"}", "2ms"), "two cycles"));
}

TEST_CASE("generate: The settings of the links are in the tables") {
  MemoryFileSystem files = plant(R"("map": [{"symbol": "SPEED", "number": 7}], "status": "off", "keep": ["::1"])");
  CHECK(run_tool({"generate", "plant.json", "-o", "out"}, files).code == 0);
  const std::string& tables = files.files["out/tables_gen.cpp"];
  CHECK(contains(tables, "    {2, 7, link::WordOrder::as_link, link::OnLoss::as_link},  // SPEED\n"));
  CHECK(contains(tables,
                 "    {.rows = links::kLinkRows0, .word_order = link::WordOrder::low_first, .status_block = "
                 "link::kNowhere, .keep = links::kKeep0},\n"));
}

}  // namespace
}  // namespace symplant::test
