// symplant generate: what is written, and when nothing is.
#include "app/depfile.hpp"
#include "app_support.hpp"
#include "base/file_system.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kFiles{"CMakeLists.txt", "devices_gen.hpp", "main_gen.cpp",
                                      "plant_gen.hpp",  "tables_gen.cpp",  "types_gen.hpp"};

TEST_CASE("generate: six files, and no other") {
  MemoryFileSystem files = lists();
  const std::size_t before = files.files.size();
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  for (const std::string& name : kFiles) CHECK(files.files.count("out/" + name) == 1);
  CHECK(files.files.size() == before + kFiles.size());
}

TEST_CASE("generate: files that have not changed are not written again") {
  MemoryFileSystem files = lists();
  run_tool({"generate", "excell.csv", "-o", "out"}, files);
  files.written.clear();
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  CHECK(files.written.empty());
  files.files["out/types_gen.hpp"] += "// mine\n";
  CHECK(run_tool({"generate", "excell.csv", "-o", "out"}, files).code == 0);
  CHECK(files.written == std::vector<std::string>{"out/types_gen.hpp"});
}

TEST_CASE("generate: warnings change nothing, an error or an unreadable list is 2 and writes nothing") {
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

TEST_CASE("generate: a place that cannot be written is 3, and no depfile is there then") {
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

TEST_CASE("generate: the depfile comes last and names what the files were made from") {
  MemoryFileSystem files = lists();
  files.files["a b.csv"] = excell();
  CHECK(run_tool({"generate", "a b.csv", "-o", "out", "--depfile", "plant.d"}, files).code == 0);
  CHECK(files.written.back() == "plant.d");
  CHECK(files.files["plant.d"] == "out/tables_gen.cpp: \\\n  a\\ b.csv\n");
}

TEST_CASE("Depfiles escape blanks, hashes, dollars and backslashes") {
  CHECK(app::depfile("a b", {"c#d", "e$f"}) == "a\\ b: \\\n  c\\#d \\\n  e$$f\n");
}

TEST_CASE("generate --check: 1 where a file is missing or differs, 0 where none does, nothing written") {
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

TEST_CASE("generate --templates: a template of the user's takes the place of the tool's, and is in the depfile") {
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

TEST_CASE("generate --templates: an unknown key is 2, names file and line, and nothing is written") {
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

}  // namespace
}  // namespace symplant::test
