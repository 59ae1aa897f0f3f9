// Tests of symplant check: exit codes, severities, outputs.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

TEST_CASE("check: The exit code is 1 if a finding reaches --fail-on, else 0") {
  struct Case {
    const char* list;
    int note;
    int warning;
    int error;
  };
  for (const Case& c : {Case{"clean.csv", 0, 0, 0}, Case{"note.csv", 1, 0, 0}, Case{"warning.csv", 1, 1, 0},
                        Case{"error.csv", 1, 1, 1}}) {
    INFO(c.list);
    CHECK(run_lists({"check", c.list, "--fail-on", "note"}).code == c.note);
    CHECK(run_lists({"check", c.list, "--fail-on", "warning"}).code == c.warning);
    CHECK(run_lists({"check", c.list, "--fail-on", "error"}).code == c.error);
    CHECK(run_lists({"check", c.list}).code == c.error);
  }
}

TEST_CASE("check: An unreadable file gives exit code 2 with its name, for every --fail-on") {
  for (const std::string& list : kUnreadable) {
    for (const char* fail_on : {"note", "error"}) {
      INFO(list);
      const ToolRun run = run_lists({"check", list, "--fail-on", fail_on});
      CHECK(run.code == 2);
      CHECK(contains(run.out, list));
      CHECK(contains(run.out, "error: "));
    }
  }
}

TEST_CASE("A list without I/O or without a device is an error of check, signals without a device can still be served") {
  MemoryFileSystem files;
  files.files["no_io.csv"] = list_text({{"Start"}, {"Stop"}, {"Pi", "", "REAL", "3.1", "", "VAR_GLOBAL_CONSTANT"}});
  files.files["no_device.csv"] =
      list_text({{"Start", "X1"}, {"Lamp", "Y1"}, {"L_P_TANK_I_LEVEL", "", "INT", "0", "%IW9"}});
  const auto says = [](const std::string& text, const std::string& list) {
    return list == "no_io.csv"
               ? contains(text, "none of 3 rows is I/O: constants (1), no address and no direction in the name (2)")
               : contains(text,
                          "none of 3 I/O symbols is in a device of the naming rule `LINE_PROC_DEV_I|O_TASK`: 2 named "
                          "otherwise, 1 numeric");
  };
  for (const std::string list : {"no_io.csv", "no_device.csv"}) {
    INFO(list);
    const ToolRun check = run_tool({"check", list}, files);
    CHECK(check.code == 1);
    CHECK(says(check.out, list));
    for (const std::vector<std::string>& command : {std::vector<std::string>{"model", list},
                                                    {"run", list, "--until", "1s"},
                                                    {"generate", list, "-o", "out"},
                                                    {"map", list}}) {
      const ToolRun run = run_tool(command, files);
      INFO(command[0]);
      if (list == "no_io.csv") {
        CHECK(run.code == 2);
        CHECK(run.out.empty());
        CHECK(says(run.err, list));
      } else {
        CHECK(run.code == 0);
        CHECK(contains(run.err, "no_device.csv: 1 error"));
      }
    }
  }
  // Signals without devices may be intended; a list without signals is never valid.
  files.files["plant.json"] =
      R"({"symplant": 1, "symbols": ["no_device.csv"], "check": {"severity": {"no-device": "note"}}})";
  CHECK(run_tool({"check", "plant.json"}, files).code == 0);
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["no_io.csv"], "check": {"severity": {"no-io": "note"}}})";
  CHECK(run_tool({"model", "plant.json"}, files).code == 2);
}

TEST_CASE("check: Several PLCs in one text are one finding, not one for each row") {
  const std::string head = "Type,Scope,Variable,Address,DataType,Property,Comment\n";
  const auto rows = [](const std::string& first_byte) {
    std::string text;
    for (int i = 0; i < 4; ++i) {
      text += "Tag,GlobalVariable,L_P_D_I_A" + std::to_string(i) + ",%IX" + first_byte + "." + std::to_string(i) +
              ",BOOL,,\n";
    }
    return text;
  };
  MemoryFileSystem files;
  files.files["equal.csv"] = head + rows("0") + head + rows("0");
  const std::string equal = run_tool({"check", "--verbose", "equal.csv"}, files).out;
  CHECK(contains(equal, "[SP330 several-lists]"));
  CHECK_FALSE(contains(equal, "[SP301 duplicate-symbol]"));
  files.files["other.csv"] = head + rows("0") + head + rows("5");
  const std::string other = run_tool({"check", "--verbose", "other.csv"}, files).out;
  const std::size_t first = other.find("[SP302 ");
  CHECK(first != std::string::npos);
  CHECK(other.find("[SP302 ", first + 1) == std::string::npos);
  files.files["one.csv"] = head + rows("0") + rows("0");  // without a second header they are doubles
  CHECK(contains(run_tool({"check", "--verbose", "one.csv"}, files).out, "[SP301 duplicate-symbol]"));
}

TEST_CASE("check: An empty tag table among others is a note, alone it is an error") {
  MemoryFileSystem files;
  files.files["full.xml"] = "<Tagtable name='A'><Tag type='Bool' addr='%I0.0'>L_P_D_I_A</Tag></Tagtable>";
  files.files["empty.xml"] = "<?xml version='1.0' encoding='utf-8'?>\n<Tagtable name='B'></Tagtable>";
  const ToolRun both = run_tool({"check", "full.xml", "empty.xml"}, files);
  CHECK(both.code == 0);
  CHECK(contains(both.out, "empty.xml: no symbols, left out\n"));
  CHECK(contains(run_tool({"check", "--verbose", "full.xml", "empty.xml"}, files).out,
                 "empty.xml:1:1: note: the file declares no symbol"));
  CHECK(
      contains(run_tool({"check", "--format", "json", "full.xml", "empty.xml"}, files).out, "\"severity\": \"note\""));
  CHECK(run_tool({"check", "empty.xml"}, files).code == 2);
  files.files["none.csv"] = "nothing";
  CHECK(run_tool({"check", "full.xml", "none.csv"}, files).code == 2);
}

TEST_CASE("check: Each PLANT is a separate plant, and the highest exit code counts") {
  CHECK(run_lists({"check", "clean.csv", "excell.csv"}).code == 0);
  CHECK(run_lists({"check", "clean.csv", "error.csv", "clean.csv"}).code == 1);
  const ToolRun run = run_lists({"check", "error.csv", "missing.csv", "clean.csv"});
  CHECK(run.code == 2);
  CHECK(contains(run.out, "error.csv:3"));
  CHECK(contains(run.out, "clean.csv: 8 of 8 I/O names follow"));
}

TEST_CASE("check: The JSON contains every finding of all plants, and parses") {
  const ToolRun run = run_lists({"check", "--format", "json", "warning.csv", "error.csv", "missing.csv"});
  CHECK(run.code == 2);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json.at("symplant-diagnostics") == 1);
  CHECK(json.at("findings").size() >= 3);
  CHECK(json.at("counts").at("error") == 2);
}

TEST_CASE("check: A baseline hides what is known, and only shrinks") {
  MemoryFileSystem files;
  const std::string head = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  const auto row = [](const std::string& name) { return "VAR_GLOBAL," + name + ",,,BOOL,\n"; };
  files.files["l.csv"] = head + row("L_P_A_O_UP") + row("L_P_A_I_DOWN") + row("L_P_B_O_UP") + row("L_P_B_I_DOWN");
  const auto check = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"check", "l.csv", "--fail-on", "warning"});
    return run_tool(options, files);
  };
  CHECK(check({}).code == 1);
  const ToolRun missing = check({"--baseline", "b.json"});
  CHECK(missing.code == 2);
  CHECK(contains(missing.err, "write the first baseline with `--write-baseline`"));
  const ToolRun written = check({"--write-baseline", "b.json"});
  CHECK(written.code == 0);
  CHECK(contains(written.err, "b.json: "));
  CHECK(contains(written.err, "written"));
  const ToolRun known = check({"--baseline", "b.json"});
  CHECK(known.code == 0);
  CHECK(contains(known.out, "no findings"));
  CHECK(contains(known.out, "in the baseline"));
  files.files["l.csv"] += row("L_P_C_O_UP") + row("L_P_C_I_DOWN");
  const ToolRun more = check({"--baseline", "b.json"});
  CHECK(more.code == 1);
  CHECK(contains(more.out, "L_P_C_O_UP"));
  CHECK_FALSE(contains(more.out, "L_P_A_O_UP"));
  const std::string before = files.files["b.json"];
  CHECK(check({"--write-baseline", "b.json"}).code == 1);
  CHECK(files.files["b.json"] == before);  // nothing new gets in
  files.files["l.csv"] = head + row("L_P_A_O_UP") + row("L_P_A_I_DOWN");
  const ToolRun stale = check({"--baseline", "b.json"});
  CHECK(stale.code == 1);
  CHECK(contains(stale.out, "SP626 baseline-stale"));
  CHECK(check({"--write-baseline", "b.json"}).code == 0);
  CHECK(files.files["b.json"].size() < before.size());
  CHECK(check({"--baseline", "b.json"}).code == 0);
  files.files["b.json"] = "{}";
  CHECK(check({"--baseline", "b.json"}).code == 2);
  CHECK(check({"--baseline", "b.json", "--write-baseline", "b.json"}).code == 2);
  CHECK(check({"--write-baseline", "l.csv"}).code == 2);
}

TEST_CASE("check: The names that findings propose are written to a file, and convert applies it") {
  MemoryFileSystem files;
  std::string list = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  int address = 0;
  for (int device = 1; device <= 5; ++device) {
    for (const std::string part : {"O_ADV", "I_ADV", "O_RET", "I_RET"}) {
      const std::string name = device == 3 && part == "I_RET" ? "CLAPM" : "CLAMP";
      list += fmt::format("VAR_GLOBAL,L_P_{}{}_{},,%{}X{},BOOL,\n", name, device, part, part[0] == 'O' ? 'Q' : 'I',
                          address++);
    }
  }
  files.files["l.csv"] = list + "VAR_GLOBAL,L_P_GATE_O_UP,,%IX90,BOOL,\nVAR_GLOBAL,STEP,,%IX91,BOOL,\n";
  const ToolRun run = run_tool({"check", "l.csv", "--rename-map", "map.csv"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.err, "map.csv: 3 renames proposed, 1 of them safe\n"));
  CHECK(files.files["map.csv"] ==
        "old,new,address,safe,why\nL_P_CLAPM3_I_RET,L_P_CLAMP3_I_RET,%IX11,yes,name-slip\n"
        "L_P_GATE_O_UP,L_P_GATE_I_UP,%IX90,no,direction-against-address\nSTEP,_STEP,%IX91,no,reserved-word\n");
  CHECK(run_tool({"convert", "l.csv", "new.txt", "--renames", "map.csv"}, files).code == 0);
  CHECK(contains(files.files["new.txt"], "L_P_CLAMP3_I_RET"));
  CHECK_FALSE(contains(files.files["new.txt"], "CLAPM"));
  files.faults["denied.csv"] = "permission denied";
  CHECK(run_tool({"check", "l.csv", "--rename-map", "denied.csv"}, files).code == 3);
}

TEST_CASE("check: A proposed name that is taken is left out") {
  MemoryFileSystem files;
  files.files["l.csv"] =
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,L_P_D_O_A,,%QX0,BOOL,\nVAR_GLOBAL,L_P_D_I_A,,%IX0,"
      "BOOL,\nVAR_GLOBAL,L_P D_O_A,,%QX1,BOOL,\n";
  const ToolRun run = run_tool({"check", "l.csv", "--rename-map", "map.csv"}, files);
  CHECK(contains(run.err, "map.csv: 0 renames proposed, 0 of them safe; 1 left out, since the new name is taken\n"));
}

TEST_CASE("check: The page for others has the score, stations, repairs and findings, and no script") {
  MemoryFileSystem files;
  std::string list = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  for (const std::string station : {"ST1", "ST2"}) {
    list += "VAR_GLOBAL,L_" + station + "_CLAMP_O_ADV,,,BOOL,\nVAR_GLOBAL,L_" + station + "_CLAMP_I_RET,,,BOOL,\n";
  }
  files.files["<b>.csv"] = list + "VAR_GLOBAL,<script>alert(1)</script>,,%IX7,BOOL,\n";
  const ToolRun run = run_tool({"check", "--format", "html", "<b>.csv", "none.csv"}, files);
  CHECK(run.code == 2);
  CHECK_THAT(run.out, Catch::Matchers::StartsWith("<!DOCTYPE html>"));
  CHECK(contains(run.out, "<h1>&lt;b&gt;.csv</h1>"));
  CHECK(contains(run.out, "<div class=big>80 %</div>of 5 inputs and outputs accounted for"));
  CHECK(contains(run.out, "title=\"0 of 2 symbols left over\">L_ST1<b>100&nbsp;%</b>"));
  CHECK(contains(run.out, "<h2>Most worth repairing</h2>"));
  CHECK(contains(run.out, "<tr><td>1<td><code>&lt;script&gt;alert(1)&lt;/script&gt;</code>"));
  CHECK(contains(run.out, "<summary><b>warning</b> SP204 illegal-character"));
  CHECK(contains(run.out, "<h1>none.csv</h1>\n<p>The plant cannot be read.</p>"));
  CHECK_FALSE(contains(run.out, "<script"));
  CHECK_FALSE(contains(run.out, "http"));
}

TEST_CASE("check: A list in a code page is read if the command line or plant.json names the encoding") {
  MemoryFileSystem files;
  const std::string row = "VAR_GLOBAL,\xB6\xF3_P_D_I_\xC0\xFC\xC1\xF8,X1,,BOOL,FALSE\n";
  files.files["korean.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n" + row;
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["korean.csv"]})";
  files.files["named.json"] = R"({"symplant": 1, "symbols": [{"file": "korean.csv", "encoding": "windows-949"}]})";
  const ToolRun refused = run_tool({"check", "korean.csv"}, files);
  CHECK(refused.code == 2);
  CHECK(contains(refused.out, "korean.csv:2:12: error: the bytes B6 F3 are not valid UTF-8 here"));
  CHECK(contains(refused.out, "`--encoding cp949` (`라_P_D_I_전진`)"));
  CHECK(contains(run_tool({"check", "plant.json"}, files).out, "`\"encoding\": \"cp949\"` (`라_P_D_I_전진`)"));
  CHECK(run_tool({"check", "--encoding", "EUC-KR", "korean.csv"}, files).code == 0);
  const ToolRun read = run_tool({"check", "named.json", "--verbose"}, files);
  CHECK(read.code == 0);
  CHECK(contains(read.out, "korean.csv:2:12: note: nothing drives `라_P_D_I_전진`"));
  CHECK(contains(read.out, "1 of 1 I/O names"));
  const ToolRun unknown = run_tool({"check", "--encoding", "cp94", "korean.csv"}, files);
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "unknown encoding `cp94`"));
}

TEST_CASE("check: With lists in several encodings, each message suggests a fix that works") {
  const std::string header = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n";
  const std::string row = "VAR_GLOBAL,L_P_D_O_A,Y1,,BOOL,FALSE,\n";
  MemoryFileSystem files;
  files.files["wide.csv"] = "\xFF\xFE";
  for (const char c : header + row) files.files["wide.csv"] += std::string{c, '\0'};
  files.files["west.csv"] = header + "VAR_GLOBAL,L_P_D_I_A,X1,,BOOL,FALSE,\xFC\n";
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["wide.csv", "west.csv"]})";
  CHECK(
      contains(run_tool({"check", "plant.json"}, files).out,
               "west.csv:2:37: warning: the encoding was recognized as cp1252 by few words; choose the one that reads "
               "this word correctly: `\"encoding\": \"cp1252\"` (`ü`), "));
  CHECK(contains(run_tool({"check", "west.csv"}, files).out, "correctly: `--encoding cp1252` (`ü`), "));
  CHECK(contains(run_tool({"check", "--encoding", "cp1252", "plant.json"}, files).out,
                 "write `\"encoding\": \"cp1252\"` for each of them in the `symbols` of a plant.json [SP102"));
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["wide.csv", {"file": "west.csv", "encoding": "cp1252"}]})";
  CHECK(run_tool({"check", "plant.json"}, files).code == 0);
}

TEST_CASE("check: SARIF is one run for all plants, with the exit code of the command") {
  const ToolRun run = run_lists({"check", "--format", "sarif", "warning.csv", "error.csv", "missing.csv"});
  CHECK(run.code == 2);
  const auto log = nlohmann::json::parse(run.out);
  REQUIRE(log.at("runs").size() == 1);
  const auto& sarif = log["runs"][0];
  CHECK(sarif["invocations"][0]["exitCode"] == 2);
  CHECK(sarif["results"].size() >= 3);
  CHECK(sarif["results"][0]["level"] == "error");
}

TEST_CASE("check: JUnit has a suite for each plant, and a test for every reported rule") {
  const ToolRun run = run_lists({"check", "--format", "junit", "--select", "SP302,SP401", "clean.csv", "error.csv"});
  CHECK(run.code == 1);
  CHECK(contains(run.out, "<testsuite name=\"clean.csv\""));
  CHECK(contains(run.out, "classname=\"clean.csv.SP401 operation-without-event\" name=\"nothing that fails\""));
  CHECK_FALSE(contains(run.out, "SP201"));
  CHECK(contains(run.out, "<testcase classname=\"error.csv.SP302 symbol-declared-differently\" name=\"L_P_D_I_A\""));
}

TEST_CASE("check: Findings hidden by --select and --ignore do not fail, and are counted") {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--ignore", "SP302"}, {"--select", "SP2,SP5"}, {"--select=sp4", "--select=SP2"}}) {
    INFO(options[1 % options.size()]);
    std::vector<std::string> arguments{"check"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.emplace_back("error.csv");  // a word after them is a plant
    const ToolRun run = run_lists(arguments);
    CHECK(run.code == 0);
    CHECK_FALSE(contains(run.out, "SP302"));
    CHECK(contains(run.out, options[0] == "--ignore" ? "1 left out by --ignore" : " left out by --select"));
  }
  CHECK(run_lists({"check", "missing.csv", "--select", "SP5", "--ignore", "SP1"}).code == 2);
  CHECK(run_lists({"check", "warning.csv", "--fail-on", "warning", "--ignore", "SP201"}).code == 0);
  const auto json =
      nlohmann::json::parse(run_lists({"check", "--format", "json", "--ignore", "SP302", "error.csv"}).out);
  CHECK(json.at("counts").at("left_out") == 2);  // with one that follows from it
}

TEST_CASE(
    "check: Consequences of an ignored finding go with it, those of one that is not selected are reported separately") {
  std::vector<Row> rows = bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2"});
  rows[3].type = "BOL";  // so that B2 has only an operation
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(rows);
  const auto reported = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"check", "list.csv"});
    return run_tool(options, files).out;
  };
  CHECK(contains(reported({}), "[SP313 type-of-no-io]"));
  CHECK(contains(reported({}), "follows from this (operation-without-event)"));
  CHECK(contains(reported({}), "; 1 warning\n"));
  const std::string selected = reported({"--select", "SP401"});
  CHECK(contains(selected, "[SP401 operation-without-event]"));
  CHECK(contains(selected, "; 1 warning, 1 left out by --select\n"));
  CHECK(
      contains(reported({"--ignore", "SP313"}), "; no findings, 1 left out by --ignore and 1 that follow from them\n"));
  const std::string cause = reported({"--ignore", "SP401"});
  CHECK(contains(cause, "[SP313 type-of-no-io]"));
  CHECK_FALSE(contains(cause, "operation-without-event"));
}

TEST_CASE("check: Naming conventions of a file report each convention once for a type, and propose names") {
  MemoryFileSystem files;
  files.files["list.csv"] =
      list_text({{"L_P_D_O_A", "Y1"}, {"L_P_D_I_A", "X1"}, {"L_P_E_O_A", "Y2"}, {"L_P_E_I_A", "X2"}});
  files.files["names.json"] = R"([{ "types": ["bool"], "side": "event", "prefix": ["x"] }, { "most": 5 }])";
  const std::vector<std::string> check{"check", "list.csv", "--conventions", "names.json"};
  std::vector<std::string> with_map = check;
  with_map.insert(with_map.end(), {"--rename-map", "renames.csv", "--fail-on", "warning"});
  const ToolRun run = run_tool(with_map, files);
  CHECK(run.code == 1);
  CHECK(contains(
      run.out, "`L_P_D_I_A` of the type `BOOL` does not begin with `x`; a convention wants that: write `xL_P_D_I_A`"));
  CHECK(contains(run.out, "1 more like `convention # (prefix x), BOOL`: `L_P_E_I_A`"));
  CHECK(contains(run.out, "3 more like `convention # (0 to 5), BOOL`"));
  CHECK(contains(run.out, "2 warnings"));
  CHECK(contains(files.files["renames.csv"], "L_P_E_I_A,xL_P_E_I_A"));
  files.files["names.json"] = R"([{ "letters": "upper", "prefx": ["x"] }])";
  const ToolRun unknown = run_tool(check, files);
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err + unknown.out,
                 "names.json:1:24: error: the key `prefx` is unknown here; did you mean `prefix`?"));
  files.files["names.json"] = "{}";
  CHECK(contains(run_tool(check, files).out + run_tool(check, files).err, "this is no list of naming conventions"));
  CHECK(run_tool({"check", "list.csv", "--conventions", "none.json"}, files).code == 2);
}

TEST_CASE("check: An unknown rule, or one that cannot be ignored, is a usage error with a hint") {
  const ToolRun unknown = run_lists({"check", "clean.csv", "--select", "event-not-drven"});
  CHECK(unknown.code == 2);
  CHECK(unknown.out.empty());
  CHECK(contains(unknown.err, "did you mean `event-not-driven`?"));
  const ToolRun binding = run_lists({"check", "clean.csv", "--ignore", "SP4,SP316"});
  CHECK(binding.code == 2);
  CHECK(contains(binding.err, "`symbols-overlap` cannot be ignored"));
}

TEST_CASE("check and explain: A former slug works, with one warning, what was removed has no effect") {
  const ToolRun run = run_lists({"check", "clean.csv", "--select", "nobody-moves", "--ignore", "nobody-moves,SP5"});
  CHECK(run.code == 0);
  CHECK(run.err == "warning: the rule `SP5` no longer exists\nwarning: `nobody-moves` is now `event-not-driven`\n");
  const ToolRun page = run_tool({"explain", "nobody-moves"});
  CHECK(page.code == 0);
  CHECK(page.out == run_tool({"explain", "SP404"}).out);
  CHECK(page.err == "warning: `nobody-moves` is now `event-not-driven`\n");
  CHECK(run_tool({"explain", "event-not-driven"}).err.empty());
}

TEST_CASE("check: --output writes a file, and nothing to standard output") {
  MemoryFileSystem files = lists();
  const ToolRun run = run_tool({"check", "warning.csv", "--output", "result.txt"}, files);
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  CHECK(contains(files.files["result.txt"], "SP201"));
  CHECK_FALSE(contains(files.files["result.txt"], "\x1B"));
}

TEST_CASE("check: An unwritable output gives exit code 3") {
  MemoryFileSystem files = lists();
  files.faults["result.txt"] = "no space left";
  const ToolRun run = run_tool({"check", "warning.csv", "--output", "result.txt"}, files);
  CHECK(run.code == 3);
  CHECK(contains(run.err, "result.txt"));
}

TEST_CASE("check: A folder, a missing file and a file without permission give exit code 2") {
  base::DiskFileSystem files;
  const TemporaryFolder folder;
  CHECK(run_tool({"check", folder.path()}, files).code == 2);
  CHECK(run_tool({"check", folder / "missing.csv"}, files).code == 2);
  const std::string secret = folder.write("secret.csv", excell());
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  if (!std::ifstream(secret).good()) CHECK(run_tool({"check", secret}, files).code == 2);  // root may read every file
  CHECK(run_tool({"check", folder.write("good.csv", excell())}, files).code == 0);
}

}  // namespace
}  // namespace symplant::test
