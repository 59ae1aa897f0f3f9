// Tests of symplant generate: what it writes, and when it writes nothing.
#include "app/depfile.hpp"
#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kFiles{"CMakeLists.txt", "fmu_gen.cpp",    "formulas_gen.hpp", "main_gen.cpp",
                                      "plant_gen.hpp",  "tables_gen.cpp", "tables_gen.hpp",   "types_gen.hpp"};

TEST_CASE("generate: Eight files are written, and no other") {
  MemoryFileSystem files = lists();
  const std::size_t before = files.files.size();
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  for (const std::string& name : kFiles) CHECK(files.files.count("out/" + name) == 1);
  CHECK(files.files.size() == before + kFiles.size());
}

TEST_CASE("generate: Unchanged files are not written again") {
  MemoryFileSystem files = lists();
  run_tool({"generate", "excell.csv", "-o", "out"}, files);
  files.written.clear();
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  CHECK(files.written.empty());
  files.files["out/types_gen.hpp"] += "// mine\n";
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  CHECK(files.written == std::vector<std::string>{"out/types_gen.hpp"});
}

TEST_CASE("generate: A warning has no effect, an error or unreadable list gives exit code 2 and writes nothing") {
  CHECK(run_lists({"generate", "warning.csv", "-o", "out"}).code == 0);
  std::vector<std::string> bad = kUnreadable;
  bad.push_back("error.csv");
  for (const std::string& list : bad) {
    INFO(list);
    MemoryFileSystem files = lists();
    const ToolRun run = run_tool({"generate", list, "-o", "out", "--depfile", "out/plant.d"}, files);
    CHECK(run.code == 2);
    CHECK(contains(run.err, list));
    CHECK(files.written.empty());
  }
}

TEST_CASE("generate: An unwritable folder gives exit code 3 without a depfile") {
  MemoryFileSystem files = lists();
  files.faults["out/tables_gen.cpp"] = "read-only file system";
  const ToolRun run = run_tool({"generate", "excell.csv", "-o", "out", "--depfile", "out/plant.d"}, files);
  CHECK(run.code == 3);
  CHECK(contains(run.err, "out/tables_gen.cpp"));
  CHECK(files.files.count("out/plant.d") == 0);

  base::DiskFileSystem disk;
  const TemporaryFolder folder;
  const std::string list = folder.write("excell.csv", excell());
  folder.write("file", "");
  CHECK(run_tool({"generate", list, "-o", folder / "file"}, disk).code == 3);
}

TEST_CASE("generate: The depfile is written last and lists the input files") {
  MemoryFileSystem files = lists();
  files.files["a b.csv"] = excell();
  CHECK(run_tool({"generate", "a b.csv", "-o", "out", "--depfile", "plant.d"}, files).code == 0);
  CHECK(files.written.back() == "plant.d");
  CHECK(files.files["plant.d"] == "out/tables_gen.cpp: \\\n  a\\ b.csv\n");
}

TEST_CASE("Depfiles escape blanks, hashes, dollars and backslashes") {
  CHECK(app::depfile("a b", {"c#d", "e$f"}) == "a\\ b: \\\n  c\\#d \\\n  e$$f\n");
}

TEST_CASE("generate --check: The exit code is 1 if a file is missing or differs, else 0, nothing is written") {
  MemoryFileSystem files = lists();
  const std::size_t before = files.files.size();
  const ToolRun missing = run_tool({"generate", "excell.csv", "-o", "out", "--check"}, files);
  CHECK(missing.code == 1);
  CHECK(contains(missing.out, "out/types_gen.hpp is missing"));
  CHECK(files.files.size() == before);
  run_tool({"generate", "excell.csv", "-o", "out"}, files);
  files.written.clear();
  CHECK(run_tool({"generate", "excell.csv", "-o", "out", "--check"}, files).code == 0);
  files.files["out/types_gen.hpp"] += " ";
  const ToolRun stale = run_tool({"generate", "excell.csv", "-o", "out", "--check"}, files);
  CHECK(stale.code == 1);
  CHECK(contains(stale.out, "out/types_gen.hpp is out of date"));
  CHECK(files.written.empty());
}

TEST_CASE("generate --templates: A user template replaces that of the tool, and is in the depfile") {
  base::DiskFileSystem files;
  const TemporaryFolder folder;
  const std::string list = folder.write("excell.csv", excell());
  folder.write("templates/main_gen.cpp.mustache", "// mine: {{plant}}\n");
  const ToolRun run = run_tool(
      {"generate", list, "-o", folder / "out", "--templates", folder / "templates", "--depfile", folder / "plant.d"},
      files);
  CHECK(run.code == 0);
  CHECK(read_bytes(folder / "out/main_gen.cpp") == "// mine: excell\n");
  CHECK(contains(read_bytes(folder / "out/types_gen.hpp"), "enum class State"));
  CHECK(contains(read_bytes(folder / "plant.d"), "main_gen.cpp.mustache"));
}

TEST_CASE("generate --templates: An unknown key gives exit code 2 with file and line, and nothing is written") {
  base::DiskFileSystem files;
  const TemporaryFolder folder;
  const std::string list = folder.write("excell.csv", excell());
  folder.write("templates/main_gen.cpp.mustache", "// {{plant}}\n\nint {{planet}};\n");
  const ToolRun run = run_tool({"generate", list, "-o", folder / "out", "--templates", folder / "templates"}, files);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "main_gen.cpp.mustache:3: "));
  CHECK(contains(run.err, "`planet`"));
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
  CHECK(run_tool({"generate", list, "-o", folder / "out", "--templates", folder / "none"}, files).code == 2);
}

/// A described cylinder, with or without a behavior.
MemoryFileSystem described(const std::string& device) {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"L_P_CYL1_O_ADV", "L_P_CYL1_I_ADV", "L_P_CYL1_I_RET"}));
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "devices": {"L_P_CYL*": {)" + device + "}}}";
  return files;
}
const std::string kBehaving = R"("type": "Cylinder", "behaviour": "SlowCylinder", "inputs": {"air": "L_P_CYL1.RET"})";

TEST_CASE("generate --behaviours: The user file is written once, and never overwritten") {
  MemoryFileSystem files = described(kBehaving);
  const ToolRun first = run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine"}, files);
  CHECK(first.err == "");
  CHECK(first.code == 0);
  CHECK(contains(first.out, "mine/SlowCylinder_behavior.hpp: written for you to fill in\n"));
  CHECK(contains(files.files["mine/SlowCylinder_behavior.hpp"], "class SlowCylinder : public Cylinder {"));
  CHECK(contains(files.files["out/tables_gen.cpp"], "behaviour_of<SlowCylinder, Cylinder>()"));
  CHECK(contains(files.files["out/types_gen.hpp"], "    air,  // L_P_CYL1.RET\n"));

  files.files["mine/SlowCylinder_behavior.hpp"] = "mine";
  files.written.clear();
  const ToolRun second = run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine"}, files);
  CHECK(second.code == 0);
  CHECK_FALSE(contains(second.out, "SlowCylinder"));
  CHECK(files.written.empty());
  CHECK(files.files["mine/SlowCylinder_behavior.hpp"] == "mine");
}

TEST_CASE("generate --behaviours: An unwritable file gives 3, an invalid class gives 2, both without a plant") {
  MemoryFileSystem files = described(kBehaving);
  files.faults["mine/SlowCylinder_behavior.hpp"] = "no permission";
  CHECK(run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine"}, files).code == 3);
  CHECK(files.written.empty());
  MemoryFileSystem bad = described(R"("behaviour": "class")");
  const ToolRun run = run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine"}, bad);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "`class` is not a valid C++ class name; write `class_`, for example"));
  CHECK(bad.written.empty());
}

TEST_CASE("generate --check: The missing file of a behavior is reported if the folder is given") {
  MemoryFileSystem files = described(kBehaving);
  run_tool({"generate", "plant.json", "-o", "out"}, files);
  CHECK(run_tool({"generate", "plant.json", "-o", "out", "--check"}, files).code == 0);
  const ToolRun run = run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine", "--check"}, files);
  CHECK(run.code == 1);
  CHECK(contains(run.out, "mine/SlowCylinder_behavior.hpp is missing\n"));
  CHECK(files.files.count("mine/SlowCylinder_behavior.hpp") == 0);
}

TEST_CASE("generate --behaviours: Without a behavior nothing is written to the folder, with a message") {
  MemoryFileSystem files = described(R"("initial": "RET")");
  const ToolRun run = run_tool({"generate", "plant.json", "-o", "out", "--behaviours", "mine"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.err, "note: no device has a `behaviour`"));
}

TEST_CASE("run: A behavior is absent if nothing is compiled, with a message") {
  MemoryFileSystem files = described(kBehaving);
  const ToolRun run = run_tool({"run", "plant.json", "--until", "1s"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out,
                 "behavior `SlowCylinder` of 1 device has no code in this program, the derived model applies; to "
                 "include its code, use `symplant generate`\n"));
}

TEST_CASE("generate: The plant is written as an FMU, with equal bytes for equal inputs") {
  MemoryFileSystem files = lists();
  const ToolRun run = run_tool({"generate", "excell.csv", "--fmu", "cell.fmu", "--depfile", "cell.d"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "cell.fmu: FMI 2.0 for co-simulation, "));
  CHECK(files.files["cell.d"] == "cell.fmu: \\\n  excell.csv\n");
  const std::string first = files.files["cell.fmu"];
  CHECK(first.substr(0, 2) == "PK");
  CHECK(run_tool({"generate", "excell.csv", "--fmu", "cell.fmu", "--check"}, files).code == 0);
  files.files["cell.fmu"].back() ^= 1;
  CHECK(run_tool({"generate", "excell.csv", "--fmu", "cell.fmu", "--check"}, files).code == 1);
  CHECK(run_tool({"generate", "excell.csv", "--fmu", "cell.fmu"}, files).code == 0);
  CHECK(files.files["cell.fmu"] == first);
}

TEST_CASE("generate: An FMU has the libraries that are given, and no other") {
  MemoryFileSystem files = lists();
  files.files["mine.dll"] = "MZ of mine";
  const ToolRun run =
      run_tool({"generate", "excell.csv", "--fmu", "cell.fmu", "--fmu-library", "win64=mine.dll"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "for win64\n"));
  CHECK(contains(files.files["cell.fmu"], "binaries/win64/excell.dll"));
  CHECK_FALSE(contains(files.files["cell.fmu"], "linux"));
}

TEST_CASE("generate: What an FMU cannot be made of is an error, and nothing is written") {
  MemoryFileSystem files = lists();
  files.files["mine.dll"] = "MZ";
  files.files["behaves.json"] =
      R"({"symplant": 1, "symbols": ["excell.csv"], "devices": {"EXLINE_MB_AGV": {"behaviour": "MyAgv"}}})";
  files.files["twice.json"] = R"({"symplant": 1, "symbols": ["excell.csv"],
                                  "malfunctions": [{"name": "EXLINE_MB_AGV_I_P1", "of": "EXLINE_MB_AGV", "stuck": true}]})";
  const auto error = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "generate");
    const ToolRun run = run_tool(std::move(arguments), files);
    CHECK(run.code == 2);
    CHECK(files.files.count("cell.fmu") == 0);
    return run.err;
  };
  CHECK(error({"excell.csv"}) == "error: give `-o DIR` for C++, or `--fmu FILE` for an FMU\n");
  CHECK(contains(error({"excell.csv", "-o", "out", "--fmu", "cell.fmu"}), "--output-dir excludes --fmu"));
  CHECK(contains(error({"excell.csv", "--fmu", "cell.fmu", "--templates", "t"}), "--templates requires"));
  CHECK(contains(error({"excell.csv", "--fmu", "cell.fmu", "--fmu-library", "mine.dll"}),
                 "`--fmu-library mine.dll`: give PLATFORM=FILE"));
  CHECK(contains(error({"excell.csv", "--fmu", "cell.fmu", "--fmu-library", "win64=none.dll"}), "none.dll"));
  CHECK(
      contains(error({"excell.csv", "--fmu", "cell.fmu", "--fmu-library", "../evil=mine.dll"}), "give PLATFORM=FILE"));
  CHECK(contains(error({"excell.csv", "--fmu", "cell.fmu", "--fmu-library", "linux64=mine.dll"}),
                 "`mine.dll` is not a shared library for linux64"));
  CHECK(contains(
      error({"excell.csv", "--fmu", "cell.fmu", "--fmu-library", "win64=mine.dll", "--fmu-library", "win64=mine.dll"}),
      "two files for win64"));
  CHECK(contains(error({"behaves.json", "--fmu", "cell.fmu"}), "has the custom behavior `MyAgv`, which is C++"));
  CHECK(contains(error({"twice.json", "--fmu", "cell.fmu"}), "the name `EXLINE_MB_AGV_I_P1`"));
}

}  // namespace
}  // namespace symplant::test
