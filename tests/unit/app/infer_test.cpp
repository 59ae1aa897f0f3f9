// Tests of symplant infer.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "app_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

std::vector<Row> station_rows() {
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, bool output) {
    rows.push_back({name, "", "BOOL", "FALSE", (output ? "%QX" : "%IX") + std::to_string(rows.size())});
  };
  for (const std::string& station : {std::string("S10"), std::string("S20"), std::string("S30")}) {
    for (const char* robot : {"_RB1_", "_RB2_"}) {
      for (int i = 1; i <= 4; ++i) {
        add(station + "_Q" + robot + "PROG_SELECT_" + std::to_string(i), true);
        add(station + "_I" + robot + "PROG_ECHO_" + std::to_string(i), false);
      }
      add(station + "_Q" + robot + "START", true);
      add(station + "_I" + robot + "RUNNING", false);
      add(station + "_I" + robot + "AIR_OK", false);
    }
    for (const char* device : {"_CLAMP1_", "_CLAMP2_", "_PIN_"}) {
      for (const char* task : {"ADV", "RET"}) {
        add(station + "_SOL" + device + task, true);
        add(station + "_LS" + device + task + "1", false);
      }
    }
    add(station + "_PL_FAULT", true);
  }
  return rows;
}

MemoryFileSystem stations() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(station_rows());
  return files;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

/// The numbers of the lines of a report that contain a text, separated by commas.
std::string numbers_of(const std::string& report, const std::string& text) {
  std::istringstream lines(report);
  std::string numbers;
  for (std::string line; std::getline(lines, line);) {
    if (!contains(line, text) || line.find_first_of("123456789") > 4) continue;
    numbers.append(numbers.empty() ? "" : ",").append(std::to_string(std::stoul(line)));
  }
  return numbers;
}

/// In the lines of the correspondences of SELECT and ECHO.
constexpr const char* kEcho = "PROG_SELECT_1 -> S10_I_";

std::size_t paired(const std::string& report) {
  const std::string line = last_line(report);
  return std::stoul(line.substr(line.find('(') + 1));
}

/// The tool on a terminal, with the answers of a person.
ToolRun run_with_answers(std::vector<std::string> arguments, MemoryFileSystem& files, const std::string& answers) {
  arguments.insert(arguments.begin(), "symplant");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  std::ostringstream out;
  std::ostringstream err;
  std::istringstream in(answers);
  app::Context context{files, out, err};
  context.answers = &in;
  const int code = app::run_tool(static_cast<int>(argv.size()), argv.data(), context);
  return {code, out.str(), err.str()};
}

TEST_CASE("infer: The naming rule that it writes pairs what it reports") {
  MemoryFileSystem files = stations();
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK(run.out.starts_with("list.csv: GX IEC Developer 7 global variable list, 105 rows, 51 outputs and 54 inputs\n"));
  CHECK_FALSE(numbers_of(run.out, kEcho).empty());
  CHECK(paired(run.out) >= 80);
  CHECK(last_line(run.out).ends_with("; next: symplant check list.csv --naming naming.json"));
  const ToolRun check = run_tool({"check", "list.csv", "--naming", "naming.json"}, files);
  CHECK(contains(check.out, " " + std::to_string(paired(run.out)) + " ("));
}

TEST_CASE("infer: Without a file the naming rule goes to standard output, and the report to standard error") {
  MemoryFileSystem files = stations();
  const ToolRun run = run_tool({"infer", "list.csv"}, files);
  CHECK(nlohmann::json::parse(run.out).at("symplant-naming") == 1);
  CHECK(contains(run.err, "correspondences"));
  const ToolRun written = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  CHECK(files.files["naming.json"].ends_with("\n" + run.out));
}

TEST_CASE("infer: A refused correspondence is left out of the naming rule") {
  MemoryFileSystem files = stations();
  const ToolRun all = run_tool({"infer", "list.csv", "-o", "all.json"}, files);
  const ToolRun some =
      run_tool({"infer", "list.csv", "-o", "naming.json", "--refuse", numbers_of(all.out, kEcho)}, files);
  CHECK(some.code == 0);
  CHECK(contains(some.out, "; refused\n"));
  CHECK(paired(some.out) == paired(all.out) - 48);
  CHECK(contains(files.files["all.json"], "prog echo"));
  CHECK_FALSE(contains(files.files["naming.json"], "prog echo"));
}

TEST_CASE("infer: An accepted question becomes a constant") {
  MemoryFileSystem files = stations();
  const std::string question = "S#_I_RB#_AIR_OK, 6 inputs";
  const ToolRun asked = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  CHECK_FALSE(contains(files.files["naming.json"], "AIR_OK"));
  const ToolRun run =
      run_tool({"infer", "list.csv", "-o", "naming.json", "--accept", numbers_of(asked.out, question)}, files);
  CHECK(contains(run.out, "; accepted\n"));
  CHECK(contains(files.files["naming.json"], R"("role": "constant", "value": true)"));
  CHECK(contains(run_tool({"check", "list.csv", "--naming", "naming.json"}, files).out, "6 constant"));
}

TEST_CASE("infer: Interlocks are a question, and accepted they are pairs") {
  MemoryFileSystem files;
  files.files["list.csv"] = "Name,Address,Type\n";
  for (int i = 1; i <= 6; ++i) {
    for (const std::string task : {"MUTUAL_INT", "CLAMP_ADV"}) {
      const std::string bit = std::to_string(i) + (task == "CLAMP_ADV" ? ".1" : ".2");
      files.files["list.csv"] += "Q_RB" + std::to_string(i) + "_" + task + ",%QX" + bit + ",BOOL\n" + "I_RB" +
                                 std::to_string(i) + "_" + task + ",%IX" + bit + ",BOOL\n";
    }
  }
  const ToolRun asked = run_tool({"infer", "list.csv", "-o", "apart.json"}, files);
  CHECK(contains(asked.out, "interlocks with one text on both sides, which nothing drives (--accept N pairs them):\n"));
  CHECK(contains(files.files["apart.json"], R"("has": ["mutual"], "role": "interlock")"));
  CHECK(contains(run_tool({"check", "list.csv", "--naming", "apart.json"}, files).out, ", 12 interlocks"));
  const std::string number = numbers_of(asked.out, "mutual, 12 symbols");
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "paired.json", "--accept", number}, files);
  CHECK(contains(run.out, "; accepted\n"));
  CHECK(paired(run.out) == 24);
  CHECK_FALSE(contains(files.files["paired.json"], "interlock"));
}

TEST_CASE("explain: How a symbol is read") {
  MemoryFileSystem files;
  files.files["list.csv"] =
      "Name,Address,Type\noConv1_run,%QX1.1,BOOL\niConv1_running,%IX1.1,BOOL\niConv1_prox,%IX2.1,BOOL\n"
      "iSpare,%IX3.1,BOOL\n";
  files.files["naming.json"] =
      R"({ "symplant-naming": 1, "normalise": { "camel-case": true }, "ignore": ["*spare*"], "rules": [
    { "name": "lamps", "pattern": "*", "has": ["lamp"], "role": "operator" },
    { "name": "commands", "pattern": "o_{device...}_run", "side": "operation", "task": "ON" },
    { "name": "reports", "pattern": "i_{device...}_running", "side": "event", "task": "ON" } ] })";
  const auto explained = [&](const std::string& name) {
    return run_tool({"explain", "--symbol", name, "list.csv", "--naming", "naming.json"}, files);
  };
  const std::string read = explained("oconv1_run").out;
  CHECK(contains(read, "oConv1_run: %QX1.1, operation, row 2 of list.csv\n  name as patterns see it: o Conv1_run\n"));
  CHECK(contains(read, "    1  lamps: none of its words is there: lamp\n    2  commands: reads it\n"));
  CHECK(contains(read, "read: device Conv1, task ON\nin the device Conv1, with:\n  event     iConv1_running\n"));
  const std::string missed = explained("iConv1_prox").out;
  CHECK(contains(missed, "    2  commands: is for outputs only\n    3  reports: the pattern does not match\n"));
  CHECK(contains(missed, "not paired: its name does not follow the naming rule\n"));
  CHECK(contains(missed, "nearest of the other side:\n  oConv1_run ("));
  CHECK(
      contains(explained("iSpare").out, "a pattern of `ignore` matches it\nnot paired: the naming rule ignores it\n"));
  const ToolRun unknown = explained("iConv1_prx");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "no input or output is named `iConv1_prx`; did you mean `iConv1_prox`?"));
  CHECK(run_tool({"explain", "--symbol", "A", "none.csv"}, files).code == 2);
}

TEST_CASE("infer: Numbers out of range are refused with the range") {
  MemoryFileSystem files = stations();
  const ToolRun refuse = run_tool({"infer", "list.csv", "-o", "naming.json", "--refuse", "1,99"}, files);
  CHECK(refuse.code == 2);
  CHECK(contains(refuse.err, "error: --refuse 99: the correspondences are 1 to "));
  const ToolRun accept = run_tool({"infer", "list.csv", "-o", "naming.json", "--accept", "1"}, files);
  CHECK(accept.code == 2);
  CHECK(contains(accept.err, "error: --accept 1: the questions are "));
  CHECK(run_tool({"infer", "list.csv", "--refuse", "0"}, files).code == 2);
  CHECK(run_tool({"infer", "list.csv", "--refuse", "x"}, files).code == 2);
  CHECK_FALSE(files.exists("naming.json"));
}

TEST_CASE("infer: Without any correspondence no number can be refused") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"A_B_I_C"}));
  const ToolRun run = run_tool({"infer", "list.csv", "--refuse", "1"}, files);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "error: --refuse 1: there are no correspondences"));
}

TEST_CASE("infer: On a terminal each line is asked for") {
  MemoryFileSystem files = stations();
  const ToolRun all = run_tool({"infer", "list.csv", "-o", "all.json"}, files);
  CHECK(run_with_answers({"infer", "list.csv", "-o", "all.json"}, files, "").out == all.out);
  std::string answers;
  for (std::size_t i = 1; i < std::stoul(numbers_of(all.out, kEcho)); ++i) answers += "y\n";
  const ToolRun some = run_with_answers({"infer", "list.csv", "-o", "naming.json"}, files, answers + "what\nn\n");
  CHECK(paired(some.out) < paired(all.out));
  CHECK(contains(some.err, "? [y/n] "));
  const ToolRun yes = run_with_answers({"infer", "list.csv", "-o", "naming.json"}, files, std::string(200, 'y'));
  CHECK(yes.code == 0);
}

TEST_CASE("infer: On a terminal nothing is asked if an option answers") {
  MemoryFileSystem files = stations();
  CHECK(run_with_answers({"infer", "list.csv", "-o", "n.json", "--refuse", "1"}, files, "n\nn\n").err.empty());
}

TEST_CASE("infer: Yes to a question on a terminal makes a constant") {
  MemoryFileSystem files = stations();
  std::string answers;
  for (int i = 0; i < 40; ++i) answers += "y\n";
  run_with_answers({"infer", "list.csv", "-o", "naming.json"}, files, answers);
  CHECK(contains(files.files["naming.json"], R"("role": "constant", "value": true)"));
}

TEST_CASE("infer: An input is never overwritten") {
  const std::string before = stations().files["list.csv"];
  const TemporaryFolder folder;
  const std::string list = folder / "list.csv";
  base::DiskFileSystem disk;
  REQUIRE(disk.write(list, before));
  const ToolRun run = run_tool({"infer", list, "-o", list}, disk);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "is an input"));
  CHECK(*disk.read(list) == before);
}

TEST_CASE("infer: A naming rule that was edited is replaced only with --force, one that was not, at any time") {
  MemoryFileSystem files = stations();
  const std::vector<std::string> infer{"infer", "list.csv", "-o", "naming.json"};
  REQUIRE(run_tool(infer, files).code == 0);
  const std::string first = files.files["naming.json"];
  std::vector<std::string> refusing = infer;
  refusing.insert(refusing.end(), {"--refuse", "1"});
  CHECK(run_tool(refusing, files).code == 0);
  CHECK(files.files["naming.json"] != first);
  files.files["naming.json"].append("// mine\n");
  const std::string edited = files.files["naming.json"];
  const ToolRun refused = run_tool(infer, files);
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "`naming.json` already exists, and may contain your work"));
  CHECK(files.files["naming.json"] == edited);
  std::vector<std::string> forced = infer;
  forced.push_back("--force");
  CHECK(run_tool(forced, files).code == 0);
  CHECK(files.files["naming.json"] == first);
}

TEST_CASE("infer: A folder means the symbol lists in it") {
  MemoryFileSystem files = stations();
  const std::string list = files.files["list.csv"];
  files.files = {{"lists/a.csv", list}, {"lists/readme.txt", "No list at all.\n"}, {"empty/readme.txt", "No list.\n"}};
  const ToolRun run = run_tool({"infer", "lists", "-o", "naming.json", "--verbose"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.err, "left out lists/readme.txt, which is no symbol list"));
  CHECK(contains(run.out, "next: symplant check lists/a.csv --naming naming.json"));
  CHECK(contains(run_tool({"infer", "lists", "lists/a.csv"}, files).err, "check lists/a.csv --naming"));
  files.files["lists/b.csv"] = list.substr(0, list.size() / 2) + "\n\"unclosed,X1,BOOL\n";
  const ToolRun damaged = run_tool({"infer", "lists"}, files);
  CHECK(damaged.code == 2);
  CHECK(contains(damaged.err, "lists/b.csv:"));
  const ToolRun none = run_tool({"infer", "empty"}, files);
  CHECK(none.code == 2);
  CHECK(contains(none.err, "error: no file in the folder `empty` is a symbol list"));
}

MemoryFileSystem series() {
  MemoryFileSystem files = stations();
  std::vector<Row> rows = station_rows();
  for (int i = 1; i <= 5; ++i) {
    const std::string number = std::to_string(i);
    rows.push_back({"S40_SOL_GRIP" + number + "_CLOSE", "", "BOOL", "FALSE", "%QX90" + number});
    rows.push_back({"S40_LS_GRIP2" + number + "_CLOSE", "", "BOOL", "FALSE", "%IX90" + number});
  }
  files.files["list.csv"] = list_text(rows);
  return files;
}

TEST_CASE("infer: A series that names cannot pair becomes rows to fill in, and a filled row links") {
  MemoryFileSystem files = series();
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "out/naming.json"}, files);
  CHECK(contains(run.out, "out/links.csv: 5 links to fill in by hand"));
  std::string& links = files.files["out/links.csv"];
  CHECK(contains(links, "\n#S40_SOL_GRIP3_CLOSE,,CLOSE\n"));
  CHECK(contains(files.files["out/naming.json"], R"("links": "links.csv")"));
  const std::vector<std::string> check{"check", "list.csv", "--naming", "out/naming.json"};
  CHECK(contains(run_tool(check, files).out, " " + std::to_string(paired(run.out)) + " ("));
  const std::string row = "#S40_SOL_GRIP3_CLOSE,,CLOSE";
  links.replace(links.find(row), row.size(), "S40_SOL_GRIP3_CLOSE,S40_LS_GRIP23_CLOSE,CLOSE");
  CHECK(contains(run_tool(check, files).out, " " + std::to_string(paired(run.out) + 2) + " ("));
}

TEST_CASE("infer: Links that a person has filled in are kept") {
  MemoryFileSystem files = series();
  files.files["links.csv"] = "operation,event,state\nS40_SOL_GRIP3_CLOSE,S40_LS_GRIP23_CLOSE,CLOSE\n";
  const std::string before = files.files["links.csv"];
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "kept links.csv, which already exists\n"));
  CHECK(files.files["links.csv"] == before);
  CHECK(run_tool({"infer", "list.csv", "-o", "links.csv"}, files).code == 2);
  CHECK(files.files["links.csv"] == before);
}

TEST_CASE("infer: Without addresses there is nothing to infer from") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"MOTOR_RUN", ""}, {"MOTOR_ON", ""}});
  const ToolRun run = run_tool({"infer", "list.csv"}, files);
  CHECK(run.code == 2);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "no address in the lists is one of an input or output"));
}

TEST_CASE("infer: Names without any rule give no file") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"AAA", "BBB", "CCC"}));
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  CHECK(run.code == 1);
  CHECK(contains(run.out, "no naming rule was written"));
  CHECK_FALSE(files.exists("naming.json"));
}

TEST_CASE("infer: Several lists are one plant, and a plant.json means its lists") {
  MemoryFileSystem files = stations();
  std::vector<Row> rows = station_rows();
  const std::vector<Row> first(rows.begin(), rows.begin() + 40);
  const std::vector<Row> second(rows.begin() + 40, rows.end());
  files.files["a.csv"] = list_text(first);
  files.files["b.csv"] = list_text(second);
  files.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "a.csv"}, {"file": "b.csv"}]})";
  const ToolRun one = run_tool({"infer", "list.csv"}, files);
  const ToolRun two = run_tool({"infer", "a.csv", "b.csv"}, files);
  CHECK(two.out == one.out);
  CHECK(contains(two.err, "b.csv: "));
  CHECK(last_line(two.err).ends_with("symplant check a.csv b.csv --naming naming.json"));
  CHECK(run_tool({"infer", "plant.json"}, files).out == one.out);
}

TEST_CASE("infer: The result is never below the naming rule of --naming") {
  MemoryFileSystem files;
  std::vector<Row> rows;
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i);
    rows.push_back({"valve" + number + "_north", "", "BOOL", "FALSE", "%QX" + number});
    rows.push_back({"valve" + number + "_south", "", "BOOL", "FALSE", "%IX" + number});
  }
  files.files["list.csv"] = list_text(rows);
  files.files["own.json"] = R"({ "symplant-naming": 1, "name": "own", "rules": [{ "pattern": "{device}_{task}" }],
    "archetypes": [{ "name": "poles", "model": "mirror", "operation": "north", "event": "south" }] })";
  const ToolRun run = run_tool({"infer", "list.csv", "--naming", "own.json"}, files);
  CHECK(contains(last_line(run.err), "paired 100 % (8 of 8)"));
}

TEST_CASE("infer: Links of the given naming rule are written to links.csv, but not over another file") {
  MemoryFileSystem files;
  std::vector<Row> rows;
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i);
    rows.push_back({"up" + number, "", "BOOL", "FALSE", "%QX" + number});
    rows.push_back({"reed" + std::to_string(9 - i), "", "BOOL", "FALSE", "%IX" + number});
  }
  files.files["list.csv"] = list_text(rows);
  files.files["own.json"] = R"({ "symplant-naming": 1, "rules": [{ "pattern": "{device}", "task": "ON" }],
    "links": [["up0", "reed9", "UP"], ["up1", "reed8", "UP"]] })";
  const ToolRun run = run_tool({"infer", "list.csv", "--naming", "own.json", "-o", "naming.json"}, files);
  CHECK(contains(last_line(run.out), "(4 of 8)"));
  CHECK(files.files["links.csv"] == "operation,event,state\nup0,reed9,UP\nup1,reed8,UP\n");
  CHECK(contains(run_tool({"check", "list.csv", "--naming", "naming.json"}, files).out, " 4 ("));
  files.files["links.csv"] = "operation,event,state\n";
  files.files.erase("naming.json");
  const ToolRun again = run_tool({"infer", "list.csv", "--naming", "own.json", "-o", "naming.json"}, files);
  CHECK(again.code == 2);
  CHECK(contains(again.err, "`links.csv` already exists, and may contain your work"));
  CHECK_FALSE(files.exists("naming.json"));
}

TEST_CASE("infer: --verbose shows what was found and why") {
  MemoryFileSystem files = stations();
  CHECK_FALSE(contains(run_tool({"infer", "list.csv"}, files).err, "decided: "));
  CHECK(contains(run_tool({"infer", "list.csv", "--verbose"}, files).err, "decided: archetype "));
}

TEST_CASE("infer: Two runs are equal, and the order of the rows does not change the correspondences") {
  MemoryFileSystem files = stations();
  const ToolRun first = run_tool({"infer", "list.csv"}, files);
  CHECK(run_tool({"infer", "list.csv"}, files).out == first.out);
  std::vector<Row> rows = station_rows();
  std::mt19937 random(3);  // NOLINT: the same order in each run
  std::shuffle(rows.begin(), rows.end(), random);
  files.files["list.csv"] = list_text(rows);
  const ToolRun shuffled = run_tool({"infer", "list.csv"}, files);
  CHECK(shuffled.out == first.out);
  CHECK(shuffled.err == first.err);
}

TEST_CASE("infer: Names with hostile texts are shown safely") {
  MemoryFileSystem files = stations();
  std::string rows = files.files["list.csv"];
  const std::string large((std::size_t{1} << 16U) - 1, 'A');
  int address = 5'000;
  for (const std::string& name : {std::string("\"S10_Q_RB1_\x1B[31mX\""), large,
                                  std::string("\xE2\x80\xAE"
                                              "READY"),
                                  std::string("\"a,b\""), std::string("____")}) {
    rows += "VAR_GLOBAL," + name + ",,%IX" + std::to_string(++address) + ",BOOL,FALSE\n";
    rows += "VAR_GLOBAL," + name + "2,,%QX" + std::to_string(++address) + ",BOOL,FALSE\n";
  }
  files.files["list.csv"] = rows;
  const ToolRun run = run_tool({"infer", "list.csv", "-o", "naming.json"}, files);
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK_FALSE(contains(run.out, "\x1B"));
  CHECK_FALSE(contains(run.out, "\xE2\x80\xAE"));
  CHECK(run_tool({"check", "list.csv", "--naming", "naming.json"}, files).code != 2);
}

}  // namespace
}  // namespace symplant::test
