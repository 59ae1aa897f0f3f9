// A plant of hostile names, compiled: its names read back, in tables and in traces.
#include <nlohmann/json.hpp>

#include "compiled_hostile/plant_gen.hpp"
#include "compiled_hostile/types_gen.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/trace_file.hpp"

namespace symplant::test {
namespace {

CompiledText hostile() {
  return compile_text(read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/tests/unit/emit/hostile.csv"), "hostile.csv");
}

TEST_CASE("Every name of a hostile list reads back from the generated tables") {
  const CompiledText text = hostile();
  REQUIRE(text.compiled);
  const auto names = tables::split_names(::hostile::tables().symbol_names);
  REQUIRE(names.size() == 2 * text.plant().symbols.size());
  for (std::size_t i = 0; i < text.plant().symbols.size(); ++i) {
    CHECK((names[2 * i] == text.plant().symbols[i].name()));
    CHECK((names[2 * i + 1] == text.plant().symbols[i].written_address()));
  }
  const auto units = tables::split_names(::hostile::tables().unit_names);
  REQUIRE(units.size() == text.plant().units.size());
  for (std::size_t i = 0; i < units.size(); ++i) CHECK((units[i] == text.plant().units[i].path));
  CHECK(tables::model_hash(::hostile::tables()) == tables::model_hash(text.tables().tables()));
}

TEST_CASE("Every name of a hostile list reads back from a trace") {
  const tables::PlantTables& tables = ::hostile::tables();
  const auto names = tables::split_names(tables.symbol_names);
  const TemporaryFolder folder;
  {
    trace::TraceFile file({"trace", folder / "trace.jsonl"}, tables, 0, 0);
    for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) file.write({0, 1, i});
  }
  std::ifstream file(folder / "trace.jsonl");
  std::string line;
  REQUIRE(std::getline(file, line));
  for (std::size_t i = 0; i < tables.symbols.size(); ++i) {
    REQUIRE(std::getline(file, line));
    CHECK((nlohmann::json::parse(line).at("symbol").get<std::string>() == names[2 * i]));
  }
  CHECK_FALSE(std::getline(file, line));
}

}  // namespace
}  // namespace symplant::test
