// The worked example of docs/model.md, on tables made at run time.
#include "support/worked_example.hpp"

#include "app_support.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/trace/trace_file.hpp"

namespace symplant::test {
namespace {

/// The table of the example, as lines of a trace.
std::string expected_lines() {
  std::string expected;
  for (const ExampleRow& row : worked_example()) {
    const std::string time = std::to_string(row.milliseconds * tables::kMillisecond);
    std::string_view changes = row.changes;
    while (!changes.empty()) {
      const std::string_view change = changes.substr(0, changes.find(' '));
      changes.remove_prefix(std::min(changes.size(), change.size() + 1));
      const std::string name(change.substr(0, change.size() - 2));
      expected += "{\"t\":" + time + ",\"symbol\":\"EXLINE_MB_" + name +
                  "\",\"value\":" + (change.back() == '1' ? "true" : "false") + "}\n";
    }
  }
  return expected;
}

TEST_CASE("The paper's cell runs as in the worked example, every change and every state") {
  const CompiledText text = compile_text(excell(), "excell.csv");
  REQUIRE(text.compiled);
  const tables::PlantTables tables = text.tables().tables();
  plant::OwnedPlant plant(tables);

  const TemporaryFolder folder;
  {
    trace::TraceFile file({"trace", folder / "trace.jsonl"}, tables, tables::model_hash(tables), 0);
    check_worked_example(plant, [&](const trace::Record& change) { file.write(change); });
    CHECK(file.error().empty());
  }
  const std::string trace = read_bytes(folder / "trace.jsonl");
  const std::size_t lines = trace.find('\n') + 1;
  CHECK(trace.substr(lines) == expected_lines());
}

TEST_CASE("The scenario of the worked example writes the expected trace, byte by byte") {
  const TemporaryFolder folder;
  MemoryFileSystem files;
  files.files["excell.csv"] = excell();
  const ToolRun run =
      run_tool({"run", "excell.csv", "--scenario", std::string(SYMPLANT_SOURCE_DIR) + "/examples/excell/figure6.json",
                "--trace", folder / "trace.jsonl"},
               files);
  CHECK(run.code == 0);
  CHECK(run.err == "");
  const std::string trace = read_bytes(folder / "trace.jsonl");
  CHECK(trace.substr(trace.find('\n') + 1) == expected_lines());
}

TEST_CASE("The worked example runs the same after a reset") {
  const CompiledText text = compile_text(excell(), "excell.csv");
  REQUIRE(text.compiled);
  const tables::PlantTables tables = text.tables().tables();
  plant::OwnedPlant plant(tables);
  check_worked_example(plant);
  plant.reset();
  check_worked_example(plant);
}

}  // namespace
}  // namespace symplant::test
