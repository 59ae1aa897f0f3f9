// Tests of symplant convert.
#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

const std::string kSummary = "8 symbols written, 8 of them I/O (4 inputs, 4 outputs)\n";

TEST_CASE("convert: The extension of the output chooses the format, --to overrides it") {
  MemoryFileSystem files = lists();
  CHECK(run_tool({"convert", "excell.csv", "a.st"}, files).err == "a.st: " + kSummary);
  CHECK(contains(files.files["a.st"], "EXLINE_MB_AGV_I_P1 AT %IX0.1 : BOOL := FALSE; // AGV"));
  CHECK(run_tool({"convert", "excell.csv", "a.xml"}, files).code == 0);
  CHECK(contains(files.files["a.xml"], "<globalVars name=\"IO_Inputs\">"));
  CHECK(run_tool({"convert", "excell.csv", "a.XLSX"}, files).code == 0);
  CHECK(files.files["a.XLSX"].starts_with("PK"));
  CHECK(run_tool({"convert", "excell.csv", "a.csv"}, files).code == 0);
  CHECK(files.files["a.csv"].starts_with("Name,Address,Type,Initial,Comment\n"));
  CHECK(run_tool({"convert", "excell.csv", "a.txt"}, files).code == 0);
  CHECK(files.files["a.txt"].starts_with("Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"));
  CHECK(run_tool({"convert", "excell.csv", "b.csv", "--to", "gx-iec"}, files).code == 0);
  CHECK(files.files["b.csv"] == files.files["a.txt"]);
}

TEST_CASE("convert: A dash writes to standard output, except a workbook") {
  MemoryFileSystem files = lists();
  const ToolRun run = run_tool({"convert", "excell.csv", "-", "--to", "csv"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "\nEXLINE_MB_AGV_I_P1,X0001,BOOL,FALSE,"));
  CHECK(run.err == "csv: " + kSummary);
  const ToolRun workbook = run_tool({"convert", "excell.csv", "-", "--to", "tia-xlsx"}, files);
  CHECK(workbook.code == 2);
  CHECK(workbook.err == "error: `tia-xlsx` is not text: name a file instead of `-`\n");
  CHECK(files.written.empty());
}

TEST_CASE("convert: Options that do not fit together are usage errors") {
  MemoryFileSystem files = lists();
  const auto error = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"convert", "excell.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ToolRun run = run_tool(arguments, files);
    CHECK(run.code == 2);
    return run.err;
  };
  CHECK(error({"a.foo"}) ==
        "error: the name `a.foo` shows no format (.txt gx-iec, .csv csv, .st st, .xml plcopen, .xlsx tia-xlsx); give "
        "one with --to\n");
  CHECK(contains(error({"-"}), "shows no format"));
  CHECK(contains(error({"a.csv", "--dialect", "twincat"}), "`csv` has no dialects"));
  CHECK(contains(error({"a.st", "--dialect", "other"}), "--dialect"));
  CHECK(contains(error({"a.st", "--to", "other"}), "--to"));
  CHECK(contains(error({"a.st", "--renamed", "./a.st"}), "is the output, too"));
  CHECK(contains(error({"a.st", "--renamed", "-"}), "writes to a file"));
  CHECK(files.written.empty());
}

TEST_CASE("convert: An input with errors gives exit code 2 and no file") {
  for (const std::string& list : kUnreadable) {
    MemoryFileSystem files = lists();
    INFO(list);
    const ToolRun run = run_tool({"convert", list, "a.st"}, files);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "fix the errors first"));
    CHECK(files.written.empty());
  }
}

TEST_CASE("convert: An output that cannot be written is an environment error") {
  MemoryFileSystem files = lists();
  const ToolRun run = run_tool({"convert", "excell.csv", "denied.csv"}, files);
  CHECK(run.code == 3);
  CHECK(contains(run.err, "cannot write `denied.csv`"));
}

TEST_CASE("convert: What the format cannot hold is reported, and changed names are written to a file") {
  MemoryFileSystem files;
  files.files["list.csv"] = "Name,Address,Type,Initial,Comment\nSpare 1,X0,BOOL,,\nM1,M500,BOOL,,\n=x,X1,BOOL,,\n";
  const ToolRun run = run_tool({"convert", "list.csv", "a.st", "--renamed", "names.csv"}, files);
  CHECK(run.code == 0);
  CHECK(run.err ==
        "1 address is not written: the target has no such address: `M1`\n"
        "2 names are changed: a variable has a unique identifier of letters, digits and `_`: `Spare 1` is `Spare_1`, "
        "`=x` is `x`\n"
        "a.st: 3 symbols written, 2 of them I/O (2 inputs, 0 outputs)\n");
  CHECK(files.files["names.csv"] == "old,new\nSpare 1,Spare_1\n'=x,x\n");
}

TEST_CASE("convert: Symbols get the names of a file") {
  MemoryFileSystem files;
  files.files["l.csv"] = "Name,Address,Type,Initial,Comment\nA,X0,BOOL,,first\nB,X1,BOOL,,\n=C,X2,BOOL,,\n";
  const auto renamed = [&](const std::string& text) {
    files.files["map.csv"] = text;
    files.files.erase("out.csv");
    return run_tool({"convert", "l.csv", "out.csv", "--renames", "map.csv"}, files);
  };
  // Two names may be exchanged. Other columns, case and the quote of a spreadsheet do not matter.
  CHECK(renamed("why,New,Old\nx,B,a\ny,A,B\nz,C,'=C\n").code == 0);
  CHECK(contains(files.files["out.csv"], "B,X0,BOOL,,first\nA,X1,BOOL,,\nC,X2,BOOL"));
  const auto refused = [&](const std::string& text, const std::string& message) {
    INFO(text);
    const ToolRun run = renamed(text);
    CHECK(run.code == 2);
    CHECK(contains(run.err, message));
    CHECK(files.files.count("out.csv") == 0);
  };
  refused("", "map.csv:1: error: the file is empty");
  refused("old,other\nA,D\n", "map.csv:1: error: the first row must name the columns `old` and `new`");
  refused("old,new\nA,\n", "map.csv:2: error: a name is empty");
  refused("old,new\nA,D\na,E\n", "map.csv:3: error: `a` is renamed in line 2 already");
  refused("old,new\nX,D\n", "map.csv:2: error: no symbol is called `X`");
  refused("old,new\nA,b\n", "map.csv:2: error: another symbol is called `b`");
  refused("old,new\nA,D\nB,d\n", "map.csv:3: error: `d` is the new name in line 2, too");
  refused("old,new\nA,\"D\n", "a quote is never closed");
  CHECK(run_tool({"convert", "l.csv", "out.csv", "--renames", "none.csv"}, files).code == 2);
  CHECK(run_tool({"convert", "l.csv", "map.csv", "--renames", "map.csv"}, files).code == 2);
}

TEST_CASE("convert: A plant.json gives the symbols of all its lists, and --verbose says how they were read") {
  MemoryFileSystem files = lists();
  files.files["two.csv"] = "Name,Address,Type\nOTHER,X100,BOOL\n";
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["excell.csv", "two.csv"]})";
  const ToolRun run = run_tool({"convert", "plant.json", "a.csv", "--verbose"}, files);
  CHECK(run.code == 0);
  CHECK(contains(files.files["a.csv"], "EXLINE_MB_AGV_I_P1,X0001"));
  CHECK(contains(files.files["a.csv"], "OTHER,X100,BOOL,,\n"));
  CHECK(contains(run.err, "decided: excell.csv: format: gx-iec"));
  CHECK(contains(run.err, "9 symbols written, 9 of them I/O"));

  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["excell.csv"], "devices": {"A": 5}})";
  const ToolRun faulty = run_tool({"convert", "plant.json", "b.csv"}, files);
  CHECK(faulty.code == 2);
  CHECK(contains(faulty.err, "plant.json"));
  CHECK(files.files.count("b.csv") == 0);
}

TEST_CASE("convert: Warnings of the list are counted and change nothing") {
  MemoryFileSystem files;
  files.files["list.csv"] = "Class,Identifier,MIT-Addr.,Type\nVAR_GLOBAL,A,X0,BOOL\nVAR_GLOBAL,,X1,BOOL\n";
  const ToolRun run = run_tool({"convert", "list.csv", "a.st"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.err, "list.csv: 1 warning; `symplant check` shows them\n"));
}

TEST_CASE("convert: Writing over an input is refused, for the output and for --renamed") {
  const TemporaryFolder folder;
  base::DiskFileSystem files;
  const std::string list = folder / "list.csv";
  REQUIRE(files.write(list, excell()));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"convert", list, list},
        std::vector<std::string>{"convert", list, folder / "a.st", "--renamed", list}}) {
    const ToolRun run = run_tool(arguments, files);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "is an input: writing there would destroy it"));
    CHECK(*files.read(list) == excell());
  }
  CHECK_FALSE(files.exists(folder / "a.st"));
}

}  // namespace
}  // namespace symplant::test
