// Lists of plant.json: patterns of files, columns, parts, names of several controllers.
#include "app_support.hpp"

namespace symplant::test {
namespace {

const std::string kTag = "<Tagtable name='t'><Tag type='Bool' addr='%I0.";

ToolRun check(MemoryFileSystem& files, const std::string& symbols) {
  files.files["plant.json"] = R"({"symplant": 1, "symbols": )" + symbols + "}";
  return run_tool({"check", "plant.json"}, files);
}

TEST_CASE("lists: A pattern names all files that match, sorted by path") {
  MemoryFileSystem files;
  files.files["tags/b.xml"] = kTag + "1'>L_P_B_I_X</Tag></Tagtable>";
  files.files["tags/a.xml"] = kTag + "0'>L_P_A_I_X</Tag></Tagtable>";
  files.files["tags/notes.txt"] = "nothing";
  files.files["tags/.hidden.xml"] = "nothing";
  const ToolRun run = check(files, R"(["tags/*.xml"])");
  CHECK(run.code == 0);
  CHECK(run.out.find("tags/a.xml: TIA Portal") < run.out.find("tags/b.xml: TIA Portal"));
  CHECK(contains(run.out, "plant.json: 2 of 2 I/O names of 2 lists follow"));
  const ToolRun none = check(files, R"(["tags/*.csv"])");
  CHECK(none.code == 2);
  CHECK(contains(none.out, "plant.json:1:29: error: no file matches `tags/*.csv`; correct the path"));
}

TEST_CASE("lists: A pattern may be in the name of a folder, too") {
  MemoryFileSystem files;
  files.files["line1.csv"] = "Name,Address\nL_P_A_I_X,%IX0\n";
  files.files["line2.csv"] = "Name,Address\nL_P_B_I_X,%IX1\n";
  CHECK(contains(check(files, R"(["line?.csv"])").out, "2 of 2 I/O names of 2 lists"));
}

TEST_CASE("lists: plant.json gives columns, sheet and part of a list") {
  MemoryFileSystem files;
  files.files["io.csv"] = "A,B,C\nL_P_A_I_X,AB_1,%IX0\nL_P_B_I_X,AB_2,%IX1\n";
  const ToolRun asked = check(files, R"(["io.csv"])");
  CHECK(asked.code == 2);
  CHECK(contains(asked.out, R"(write `"columns": { "name": 1 }` or 2 in plant.json)"));
  CHECK(check(files, R"([{"file": "io.csv", "columns": {"name": "A"}}])").code == 0);
  CHECK(contains(check(files, R"([{"file": "io.csv", "part": 2}])").out, "SP"));
}

TEST_CASE("lists: A symbol with its address as its name has its controller before it where there are several") {
  MemoryFileSystem files;
  files.files["1.csv"] = "Device Name,Comment\nX0,start\n";
  files.files["2.csv"] = "Device Name,Comment\nX0,stop\n";
  const std::string lists = R"([{"file": "1.csv"}, {"file": "2.csv", "controller": "PLC2"}])";
  files.files["plant.json"] = R"({"symplant": 1, "symbols": )" + lists + "}";
  const ToolRun map = run_tool({"map", "plant.json"}, files);
  CHECK(map.code == 0);
  CHECK(contains(map.out, "PLC2:X0"));
  CHECK_FALSE(contains(map.out, "SP301"));
  const ToolRun one = check(files, R"(["1.csv"])");
  CHECK(contains(one.out, "`X0` has 1 level"));
}

TEST_CASE("lists: --columns is read by every command and explained if it cannot be") {
  MemoryFileSystem files;
  files.files["io.csv"] = "A,B,C\nL_P_A_I_X,AB_1,%IX0\nL_P_B_I_X,AB_2,%IX1\n";
  CHECK(run_tool({"check", "io.csv", "--columns", "name=A,address=3"}, files).code == 0);
  CHECK(run_tool({"map", "io.csv", "--columns", "name=A,address=C"}, files).code == 0);
  const ToolRun wrong = run_tool({"check", "io.csv", "--columns", "tag=A"}, files);
  CHECK(wrong.code == 2);
  CHECK(contains(wrong.err, "unknown column `tag`; choose one of `name`, `address`"));
}

TEST_CASE("lists: Words of CIO are inputs or outputs as the user says") {
  MemoryFileSystem files;
  files.files["io.csv"] = "NAME\tADDRESS\tDATATYPE\nL_P_A_I_X\t10.05\tBOOL\nL_P_A_O_X\t100.00\tBOOL\nM\t200.00\tBOOL\n";
  CHECK(contains(run_tool({"check", "io.csv"}, files).out, "none of 3 rows is I/O"));
  const ToolRun run = run_tool({"check", "io.csv", "--cio", "inputs=0-99,outputs=100-199"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "2 of 2 I/O names follow"));
  CHECK(check(files, R"([{"file": "io.csv", "cio": "inputs=10,outputs=100"}])").code == 0);
  CHECK(contains(check(files, R"([{"file": "io.csv", "cio": "inputs=10-9"}])").out,
                 "`inputs=10-9` is no range of words"));
  CHECK(contains(run_tool({"check", "io.csv", "--cio", "in=1"}, files).err, "`in=1` is no range of words"));
}

}  // namespace
}  // namespace symplant::test
