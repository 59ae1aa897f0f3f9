// The current values of symbols and when operations last came on.
#include "symplant/trace/history.hpp"

#include "support/bare_tables.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

using tables::DataType;
using tables::Direction;

tables::SymbolRow symbol(DataType type, Direction direction, std::uint32_t index) {
  return {index, tables::kNone, 0, 2, tables::symbol_kind(type, direction, tables::AddressForm::none, false)};
}

TEST_CASE("The time at which an operation came on is kept for bits and numbers of one index apart") {
  const std::vector<tables::SymbolRow> symbols{
      symbol(DataType::boolean, Direction::operation, 0), symbol(DataType::boolean, Direction::operation, 1),
      symbol(DataType::int_, Direction::operation, 0), symbol(DataType::boolean, Direction::event, 1)};
  tables::PlantTables rows = bare_tables("plant", 64, 64);
  rows.symbols = symbols;
  rows.operation_slots = 1;
  const trace::PlantNames names(rows);
  trace::History history(names);
  CHECK(history.rose(0) == -1);
  history.apply({5, 1, 0});
  history.apply({6, 7, 2});
  history.apply({7, 1, 3});  // an event
  history.apply({8, 9, 2});  // on before
  CHECK(history.rose(0) == 5);
  CHECK(history.rose(1) == -1);
  CHECK(history.rose(2) == 6);
  CHECK(history.since(2) == 8);
  CHECK(history.value(3) == 1);
}

}  // namespace
}  // namespace symplant::test
