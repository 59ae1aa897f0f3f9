// The summary of a plant.
#include "symplant/host/summary.hpp"

#include <vector>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

using tables::AddressForm;
using tables::DataType;
using tables::Direction;

TEST_CASE("The summary shows what can move and names the events that no device drives") {
  const std::vector<tables::UnitRow> units{{0, 0, 0, 0, 0, 0}, {0, 0, 0, 1, 1, 0}};
  const auto event = [](std::uint32_t index, std::uint32_t unit, bool moved) {
    return tables::SymbolRow{index, unit, 0, 2,
                             tables::symbol_kind(DataType::boolean, Direction::event, AddressForm::none, moved)};
  };
  const std::vector<tables::SymbolRow> symbols{
      {0, 0, 0, 2, tables::symbol_kind(DataType::boolean, Direction::operation, AddressForm::none, true)},
      event(0, 0, true),
      event(1, 1, false),
      event(2, tables::kNone, false)};
  const std::string names{"OP\0\0EV\0\0PB\0\0\x1b[31m\xE2\x80\xAE!\0\0", 24};
  tables::PlantTables tables = bare_tables("cell", 64, 64, 0, symbols);
  tables.units = units;
  tables.symbol_names = names;
  tables.list_names = {"cell.csv", 9};
  const std::string_view more[] = {"a further line"};
  const std::string text = host::summary(tables, 0x1234, more);
  CHECK(contains(text, "plant cell: 4 I/O symbols from cell.csv (1 operation, 3 events), model 0000000000001234\n"));
  CHECK(contains(text, "a further line\n"));
  CHECK(contains(text, "can move: 1 of 2 devices, using 1 of 1 operation\n"));
  CHECK(contains(text, "not driven: 2 of 3 events: PB, ?[31m?!\n"));  // no escape reaches the terminal
}

TEST_CASE("Behaviors without code are reported, with their number of devices") {
  const std::vector<tables::BehaviourUnit> units{{0, 0, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}, {3, 1, 0, 0, 0, 0}};
  tables::PlantTables tables = bare_tables("cell", 64, 64);
  tables.behaviour_units = units;
  tables.behaviour_names = std::string_view("Lift\0Stop\x1b\0", 11);
  std::vector<engine::Behaviour> code(2);
  CHECK(host::behaviour_lines(tables, code).empty());
  code[1].replaces = 1 + 8;
  CHECK(host::behaviour_lines(tables, code) == "behavior `Stop?` replaces d_ext, l_leave of 2 devices\n");
  CHECK(host::behaviour_lines(tables, {}) ==
        "behavior `Lift` of 1 device has no code in this program, the derived model applies; to include its code, use "
        "`symplant generate`\n"
        "behavior `Stop?` of 2 devices has no code in this program, the derived model applies; to include its code, "
        "use `symplant generate`\n");
}

TEST_CASE("Formulas that C++ replaces are reported") {
  std::vector<tables::CompiledFormula> compiled(2);
  tables::ValueTables values;
  values.formula_texts = std::string_view("2 * level\0flow\x1b\0", 16);
  values.compiled = compiled;
  CHECK(host::formula_lines(values).empty());
  compiled[1].replaced = true;
  CHECK(host::formula_lines(values) == "formula `flow?` is replaced by C++\n");
}

}  // namespace
}  // namespace symplant::test
