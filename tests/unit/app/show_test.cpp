// Tests of symplant model and symplant map.
#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "base/file_system.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

TEST_CASE("model --format json: The output has I, O, S and the five functions") {
  const ToolRun run = run_lists({"model", "excell.csv", "--format", "json"});
  CHECK(run.code == 0);
  const json model = json::parse(run.out);
  CHECK(model.at("symplant-model") == 1);
  CHECK(model.at("plant") == "excell");
  REQUIRE(model.at("units").size() == 2);
  const json& agv = model.at("units")[0];
  CHECK(agv.at("path") == "EXLINE_MB_AGV");
  CHECK(agv.at("actuation") == "latched");
  CHECK(agv.at("initial") == "P1");
  CHECK(agv.at("I") == json({"EXLINE_MB_AGV_O_P2", "EXLINE_MB_AGV_O_P1"}));
  CHECK(agv.at("O") == json({"EXLINE_MB_AGV_I_P1", "EXLINE_MB_AGV_I_P2"}));
  REQUIRE(agv.at("S").size() == 2);
  CHECK(agv.at("S")[0] == json({{"name", "P1"}, {"operation", "EXLINE_MB_AGV_O_P1"}, {"event", "EXLINE_MB_AGV_I_P1"}}));
  REQUIRE(agv.at("d_ext").size() == 2);
  CHECK(agv.at("d_ext")[0].at("from") == "P2");
  CHECK(agv.at("d_ext")[0].at("to") == "P1");
  CHECK(agv.at("d_ext")[0].at("on") == "EXLINE_MB_AGV_O_P1");
  CHECK(agv.at("d_ext")[0].at("takes") == 1'000'000'000);
  CHECK(agv.at("d_ext")[0].at("after") == 0);
  CHECK(agv.at("d_int").empty());
  CHECK(agv.at("l_enter").at("P2") == json::parse(R"([{"event": "EXLINE_MB_AGV_I_P2", "on": true}])"));
  CHECK(agv.at("l_leave").at("P1") == json::parse(R"([{"event": "EXLINE_MB_AGV_I_P1", "on": false}])"));
  CHECK(agv.at("l_disable").empty());
  CHECK(model.at("symbols").size() == 8);
}

TEST_CASE("model: A table shows the eight elements, for all devices or those of a pattern") {
  const ToolRun run = run_lists({"model", "excell.csv", "--device", "*_mc"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "EXLINE_MB_MC: latched, starts in IDLE1"));
  CHECK_FALSE(contains(run.out, "EXLINE_MB_AGV:"));
  for (const char* element :
       {"\n  I ", "\n  O ", "\n  S ", "\n  d_ext ", "\n  d_int ", "\n  l_enter ", "\n  l_leave ", "\n  l_disable "}) {
    INFO(element);
    CHECK(contains(run.out, element));
  }
}

TEST_CASE("model --device: A name that is not found gives the nearest one, of tracks and places, too") {
  MemoryFileSystem files = lists();
  files.files["plant.json"] =
      R"({"symplant": 1, "symbols": ["excell.csv"], "material": {"kinds": {"box": {"length": "100 mm"}},
    "tracks": {"LINE": {"length": "1 m", "drives": [{"forward": "EXLINE_MB_MC.RUN2", "speed": "1 m/s"}]}},
    "places": {"FIXTURE": {}}}})";
  const auto message = [&](const std::string& device) {
    const ToolRun run = run_tool({"model", "plant.json", "--device", device}, files);
    CHECK(run.code == 2);
    return run.err;
  };
  CHECK(contains(message("EXLINE_MB_AGW"), "matches `EXLINE_MB_AGW`; did you mean `EXLINE_MB_AGV`?\n"));
  CHECK(contains(message("LIN"), "matches `LIN`; did you mean `LINE`?\n"));
  CHECK(contains(message("FIXTUER"), "did you mean `FIXTURE`?\n"));
  CHECK(contains(message("LINEE*"), "matches `LINEE*`: `*` matches any text, `?` one character\n"));
  CHECK(contains(message("NOTHING"), "matches `NOTHING`: `*` matches"));
}

TEST_CASE("model: Every format gives a file, an unknown format is a usage error") {
  for (const char* format : {"table", "json", "html", "dot", "svg", "mermaid", "scxml"}) {
    MemoryFileSystem files = lists();
    INFO(format);
    const ToolRun run = run_tool({"model", "excell.csv", "--format", format, "-o", "view"}, files);
    CHECK(run.code == 0);
    CHECK(run.out.empty());
    CHECK(contains(files.files["view"], "EXLINE_MB_AGV"));
  }
  CHECK(run_lists({"model", "excell.csv", "--format", "pdf"}).code == 2);
}

TEST_CASE("model --format svg --verbose: The layout of the picture is reported") {
  const ToolRun run = run_lists({"model", "excell.csv", "--format", "svg", "--verbose"});
  CHECK(contains(run.err, "decided: the picture is laid out by symplant itself\n"));
  CHECK_FALSE(contains(run_lists({"model", "excell.csv", "--format", "svg"}).err, "laid out"));
}

TEST_CASE("model and map: An error or an unreadable list gives exit code 2, a warning has no effect") {
  for (const char* command : {"model", "map"}) {
    CHECK(run_lists({command, "warning.csv"}).code == 0);
    CHECK(run_lists({command, "error.csv"}).code == 2);
    for (const std::string& list : kUnreadable) {
      INFO(command << " " << list);
      const ToolRun run = run_lists({command, list});
      CHECK(run.code == 2);
      CHECK(run.out.empty());
      CHECK(contains(run.err, list));
    }
  }
}

TEST_CASE("model -o: A file is written, an unwritable file gives exit code 3") {
  MemoryFileSystem files = lists();
  CHECK(run_tool({"model", "excell.csv", "--format", "json", "-o", "model.json"}, files).out.empty());
  CHECK(json::parse(files.files["model.json"]).at("plant") == "excell");
  files.faults["there/model.json"] = "permission denied";
  CHECK(run_tool({"model", "excell.csv", "-o", "there/model.json"}, files).code == 3);
}

/// The row of a symbol, with runs of blanks as one blank.
std::string row_of(const std::string& table, const std::string& symbol) {
  const std::size_t at = table.find(" " + symbol + " ");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = table.rfind('\n', at) + 1;
  std::string row;
  for (const char c : table.substr(begin, table.find('\n', at) - begin)) {
    if (c != ' ' || row.back() != ' ') row += c;
  }
  return row;
}

TEST_CASE("map: Each symbol has a row with list row, addresses, register, Modicon number and driver") {
  const ToolRun run = run_lists({"map", "excell.csv"});
  CHECK(run.code == 0);
  CHECK(row_of(run.out, "EXLINE_MB_AGV_I_P1") ==
        "2 EXLINE_MB_AGV_I_P1 X0001 %IX0001 discrete input 1 10002 EXLINE_MB_AGV");
  CHECK(row_of(run.out, "EXLINE_MB_MC_O_RUN2") ==
        "9 EXLINE_MB_MC_O_RUN2 Y0004 %QX0004 coil 4 00005 the PLC EXLINE_MB_MC");
}

TEST_CASE("map: A coil's Modicon number has six digits if those of its table do") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"A", "", "BOOL", "", "%QX9998"},
                                       {"B", "", "BOOL", "", "%QX9999"},
                                       {"C", "", "BOOL", "", "%IX10000"},
                                       {"D", "", "DINT", "", "%QD4999"},
                                       {"L_P_LAMP_O_ON", "", "BOOL", "", "%QX1"}});
  const ToolRun run = run_tool({"map", "list.csv"}, files);
  CHECK(contains(row_of(run.out, "A"), "coil 9998 09999"));
  CHECK(contains(row_of(run.out, "B"), "coil 9999 010000"));
  CHECK(contains(row_of(run.out, "C"), "discrete input 10000 110001"));
  CHECK(contains(row_of(run.out, "D"), "holding registers 9998-9999 49999-410000"));
}

TEST_CASE("map: Operations without effect, and events that no device drives, are shown") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"START", "X1"},
                                       {"LAMP", "Y1"},
                                       {"L_P_D_I_ON", "X2"},
                                       {"SPEED", "", "WORD", "0", "%QW5"},
                                       {"L_P_E_I_A"},
                                       {"WIDE", "", "DINT", "0", "%ID7"}});
  const ToolRun run = run_tool({"map", "list.csv"}, files);
  CHECK(run.code == 0);
  CHECK(contains(row_of(run.out, "START"), "discrete input 1 10002 -"));
  CHECK(contains(row_of(run.out, "LAMP"), "the PLC -"));
  CHECK(contains(row_of(run.out, "L_P_D_I_ON"), "discrete input 2 10003 -"));
  CHECK(contains(row_of(run.out, "SPEED"), "holding register 5 40006"));
  CHECK(contains(row_of(run.out, "L_P_E_I_A"), "- - -"));
  CHECK(contains(row_of(run.out, "WIDE"), "input registers 14-15 30015-30016 low word first -"));
}

TEST_CASE("map: Columns are aligned for names of every script") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"공정_A_B_I_P1", "X1"}, {"LINE_A_B_I_P1", "X2"}});
  const std::string out = run_tool({"map", "list.csv"}, files).out;
  const std::size_t korean = out.find("  X1 ") - out.rfind('\n', out.find("  X1 "));
  const std::size_t latin = out.find("  X2 ") - out.rfind('\n', out.find("  X2 "));
  CHECK(korean == latin + 2);  // two letters of three bytes, two columns each
}

TEST_CASE("model and map: Control characters of a list never reach the terminal") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"A\x1B[31m\x07", "X1"}, {"B\xE2\x80\xAE", "X2"}, {"L_P_D_I_A", "\x1B[0m"}});
  for (const char* command : {"map", "model", "check"}) {
    const ToolRun run = run_tool({command, "list.csv"}, files);
    INFO(command);
    CHECK(run.code == 0);
    CHECK_FALSE(contains(run.out + run.err, "\x1B"));
    CHECK_FALSE(contains(run.out + run.err, "\x07"));
    CHECK_FALSE(contains(run.out + run.err, "\xE2\x80\xAE"));
  }
}

}  // namespace
}  // namespace symplant::test
