// The default I/O map.
#include "symplant/link/modbus/io_map.hpp"

#include <tuple>

#include "support/catch.hpp"
#include "unit/exec/cell.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using link::modbus::Table;
using tables::AddressForm;
using tables::DataType;
using test::SymbolList;

namespace {

constexpr auto kIn = SymbolList::kIn;
constexpr auto kOut = SymbolList::kOut;

/// Symbol, table and number of every point.
std::vector<std::tuple<std::uint32_t, Table, int>> points(const link::modbus::IoMap& map) {
  std::vector<std::tuple<std::uint32_t, Table, int>> result;
  for (const link::modbus::IoPoint& point : map.points) result.emplace_back(point.symbol, point.table, point.number);
  return result;
}

using Points = std::vector<std::tuple<std::uint32_t, Table, int>>;
using Sizes = std::array<std::uint32_t, link::modbus::kTables>;

/// Without a status block.
const link::LinkSettings kBare{.status_block = link::kNowhere};

}  // namespace

TEST_CASE("The paper's cell is on discrete inputs 1 to 4 and coils 1 to 4") {
  const auto map = link::modbus::make_io_map(test::cell_tables(), 0, kBare);
  CHECK(points(map) == Points{{0, Table::discrete_input, 1},
                              {1, Table::discrete_input, 2},
                              {2, Table::coil, 1},
                              {3, Table::coil, 2},
                              {4, Table::discrete_input, 3},
                              {5, Table::discrete_input, 4},
                              {6, Table::coil, 3},
                              {7, Table::coil, 4}});
  CHECK(map.sizes == Sizes{16, 16, 0, 0});
  CHECK(map.packed == std::array<bool, link::modbus::kTables>{});
}

TEST_CASE("An empty list has an empty map") {
  const auto map = link::modbus::make_io_map(tables::PlantTables{}, 0, kBare);
  CHECK(map.points.empty());
  CHECK(map.sizes == Sizes{});
}

TEST_CASE("A number's register is its address counted in registers: 32 bits take two, 64 bits take four") {
  SymbolList list;
  list.add("A", kOut, 5, DataType::int_);
  list.add("B", kOut, 4, DataType::dint);
  list.add("C", kIn, 7, DataType::word);
  list.add("D", kIn, 5, DataType::lreal);
  const auto map = link::modbus::make_io_map(list.tables(), 0, kBare);
  CHECK(points(map) == Points{{0, Table::holding_register, 5},
                              {1, Table::holding_register, 8},
                              {2, Table::input_register, 7},
                              {3, Table::input_register, 20}});
  CHECK(map.points[1].last() == 9);
  CHECK(map.points[3].last() == 23);
  CHECK(map.sizes == Sizes{0, 0, 16, 32});
  CHECK(map.faults.empty());
}

TEST_CASE("A number of 8 bits has no register, unless one is given") {
  SymbolList list;
  const DataType type = GENERATE(DataType::sint, DataType::usint, DataType::byte);
  list.add("A", kOut, 1, type);
  list.add("B", kOut, 2, type);
  const std::array<link::MapRow, 1> rows{{{1, 7}}};
  link::LinkSettings settings = kBare;
  settings.rows = rows;
  const auto map = link::modbus::make_io_map(list.tables(), 0, settings);
  CHECK(points(map) == Points{{1, Table::holding_register, 7}});
  CHECK(map.of_8_bits == std::vector<std::uint32_t>{0});
}

TEST_CASE("A table's size is its highest number plus one, rounded up to a multiple of 16") {
  const auto [number, size] =
      GENERATE(table<std::uint32_t, std::uint32_t>({{0, 16}, {15, 16}, {16, 32}, {31, 32}, {65'535, 65'536}}));
  SymbolList list;
  list.add("A", kOut, number);
  CHECK(link::modbus::make_io_map(list.tables(), 0, kBare).sizes == Sizes{size, 0, 0, 0});
}

TEST_CASE("One symbol without a numeric address packs its whole table and no other") {
  SymbolList list;
  list.add("A", kOut, 40);
  list.add("B", kIn, 41);
  list.add("C", kOut, AddressForm::other);
  list.add("D", kOut, 7);
  const auto map = link::modbus::make_io_map(list.tables(), 0, kBare);
  CHECK(points(map) ==
        Points{{0, Table::coil, 0}, {1, Table::discrete_input, 41}, {2, Table::coil, 1}, {3, Table::coil, 2}});
  CHECK(map.packed == std::array<bool, link::modbus::kTables>{true, false, false, false});
  CHECK(map.sizes == Sizes{16, 48, 0, 0});
}

TEST_CASE("A number above 65535 packs its table too") {
  SymbolList list;
  list.add("A", kIn, 65'536);
  list.add("B", kIn, 3);
  const auto map = link::modbus::make_io_map(list.tables(), 0, kBare);
  CHECK(points(map) == Points{{0, Table::discrete_input, 0}, {1, Table::discrete_input, 1}});
  CHECK(map.packed[1]);
}

TEST_CASE("A symbol without an address is on no link and packs nothing") {
  SymbolList list;
  list.add("A", kOut, AddressForm::none);
  list.add("B", kOut, 9);
  const auto map = link::modbus::make_io_map(list.tables(), 0, kBare);
  CHECK(points(map) == Points{{1, Table::coil, 9}});
  CHECK(map.without_address == std::vector<std::uint32_t>{0});
  CHECK_FALSE(map.packed[0]);
}

TEST_CASE("Symbols of one address share one number") {
  SymbolList list;
  list.add("A", kOut, 5);
  list.add("B", kOut, 5);
  CHECK(points(link::modbus::make_io_map(list.tables(), 0, kBare)) == Points{{0, Table::coil, 5}, {1, Table::coil, 5}});
}

TEST_CASE("Symbols of one address share one number in a packed table, in any order") {
  SymbolList list;
  list.add("A", kIn, AddressForm::other);
  list.add("B", kIn, AddressForm::other);
  list.add("C", kIn, AddressForm::other);
  list.share(0, 2);
  CHECK(points(link::modbus::make_io_map(list.tables(), 0, kBare)) ==
        Points{{0, Table::discrete_input, 0}, {1, Table::discrete_input, 1}, {2, Table::discrete_input, 0}});
}

TEST_CASE("A packed table is full at 65536 numbers") {
  SymbolList list;
  for (int i = 0; i < 65'538; ++i) list.add("A", kOut, AddressForm::other);
  const auto map = link::modbus::make_io_map(list.tables(), 0, kBare);
  CHECK(map.points.size() == 65'536);
  CHECK(map.sizes == Sizes{65'536, 0, 0, 0});
  CHECK(map.too_many == std::vector<std::uint32_t>{65'536, 65'537});
}

TEST_CASE("Modicon numbers count from one after their table's digit") {
  CHECK(link::modbus::modicon_number(Table::coil, 0) == 1);
  CHECK(link::modbus::modicon_number(Table::coil, 65'535) == 65'536);
  CHECK(link::modbus::modicon_number(Table::discrete_input, 1) == 10'002);
  CHECK(link::modbus::modicon_number(Table::input_register, 0) == 30'001);
  CHECK(link::modbus::modicon_number(Table::holding_register, 0) == 40'001);
  CHECK(link::modbus::modicon_number(Table::discrete_input, 9998) == 19'999);
  CHECK(link::modbus::modicon_number(Table::discrete_input, 10'000) == 110'001);
  CHECK(link::modbus::modicon_number(Table::holding_register, 65'535) == 465'536);
}

TEST_CASE("A map has only the symbols of one controller, and packs them separately") {
  test::SymbolList list;
  list.controller("PLC1");
  list.add("A", test::SymbolList::kOut, tables::AddressForm::other);
  list.add("B", test::SymbolList::kIn, 7);
  list.controller("PLC2");
  list.add("C", test::SymbolList::kOut, tables::AddressForm::other);
  list.add("D", test::SymbolList::kIn, tables::AddressForm::none);
  list.add("E", test::SymbolList::kIn, 7);
  CHECK(points(link::modbus::make_io_map(list.tables(), 0, kBare)) ==
        Points{{0, Table::coil, 0}, {1, Table::discrete_input, 7}});
  const auto second = link::modbus::make_io_map(list.tables(), 1, kBare);
  CHECK(points(second) == Points{{2, Table::coil, 0}, {4, Table::discrete_input, 7}});
  CHECK(second.without_address == std::vector<std::uint32_t>{3});
}
