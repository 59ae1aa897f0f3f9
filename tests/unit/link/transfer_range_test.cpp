// The block of numbers that a PLC transfers, and writes beyond it.
#include "symplant/link/modbus/transfer_range.hpp"

#include <optional>
#include <string>
#include <vector>

#include "unit/link/image_bench.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {
namespace {

using link::modbus::NumberRange;
using link::modbus::Table;

std::optional<NumberRange> range_of(const std::vector<std::uint32_t>& coils, std::uint32_t watchdog = link::kNowhere) {
  SymbolList list;
  for (const std::uint32_t coil : coils) list.add("A" + std::to_string(coil), SymbolList::kOut, coil);
  const tables::PlantTables tables = list.tables();
  return link::modbus::transfer_range(tables, link::modbus::make_io_map(tables, 0, {.watchdog = watchdog}),
                                      Table::coil);
}

TEST_CASE("The transfer range is what the slave devices of OpenPLC transfer") {
  CHECK(range_of({1, 5}) == NumberRange{0, 6});
  CHECK(range_of({803, 805}) == NumberRange{800, 6});
  CHECK(range_of({500, 501}) == NumberRange{496, 6});
  CHECK(range_of({}) == std::nullopt);
}

TEST_CASE("A map that does not fit into OpenPLC has no transfer range") { CHECK(range_of({0, 400}) == std::nullopt); }

TEST_CASE("Written gaps count only outside of the transfer range") {
  SymbolList list;
  list.add("A", SymbolList::kOut, 1);
  list.add("B", SymbolList::kOut, 5);
  list.add("N", SymbolList::kOut, 4, tables::DataType::int_);
  ImageBench bench(list.tables());
  bench.ask({15, 0, 0, 0, 6, 1, 0});
  bench.ask({16, 0, 0, 0, 5, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(bench.gaps == 0);
  bench.ask({15, 0, 1, 0, 6, 1, 0});  // wrong by one
  CHECK(bench.gaps == 1);
  bench.ask({6, 0, 5, 0, 1});
  CHECK(bench.gaps == 2);
}

}  // namespace
}  // namespace symplant::test
