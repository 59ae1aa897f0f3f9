// The effect of a link's settings on its map, and the map's digest.
#include "support/catch.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/link/status_fields.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using link::LinkSettings;
using link::MapRow;
using link::WordOrder;
using link::modbus::Table;
using tables::AddressForm;
using tables::DataType;
using test::SymbolList;

namespace {

constexpr auto kEvent = SymbolList::kIn;
constexpr auto kOperation = SymbolList::kOut;
constexpr auto kCoils = static_cast<std::size_t>(Table::coil);
constexpr auto kHolding = static_cast<std::size_t>(Table::holding_register);
constexpr auto kInput = static_cast<std::size_t>(Table::input_register);

std::vector<int> numbers(const link::modbus::IoMap& map) {
  std::vector<int> result;
  for (const link::modbus::IoPoint& point : map.points) result.push_back(static_cast<int>(point.number));
  return result;
}

std::vector<std::string> faults(const SymbolList& list, const LinkSettings& settings = {}) {
  const tables::PlantTables tables = list.tables();
  const auto map = link::modbus::make_io_map(tables, 0, settings);
  std::vector<std::string> texts;
  for (const link::modbus::MapFault& fault : map.faults) texts.push_back(link::modbus::fault_text(tables, map, fault));
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("The status block starts at the first multiple of 100 above the highest number of all tables") {
  const auto [highest, first] = GENERATE(
      table<std::uint32_t, std::uint16_t>({{0, 100}, {98, 100}, {99, 100}, {100, 200}, {199, 200}, {65'400, 65'500}}));
  SymbolList list;
  list.add("A", kOperation, highest);
  const auto map = link::modbus::make_io_map(list.tables(), 0, {});
  REQUIRE(map.status_block);
  CHECK(*map.status_block == first);
  CHECK(map.sizes[kInput] == (first + 12U + 15U) / 16 * 16);
  CHECK(map.faults.empty());
}

TEST_CASE("The last register of a number counts for the start of the status block") {
  SymbolList list;
  list.add("A", kOperation, 25, DataType::lint);  // 100 to 103
  CHECK(link::modbus::make_io_map(list.tables(), 0, {}).status_block == 200);
}

TEST_CASE("The status block of a map without symbols starts at 100") {
  CHECK(link::modbus::make_io_map(tables::PlantTables{}, 0, {}).status_block == 100);
}

TEST_CASE("Without room above the map there is no status block, and the map says so") {
  SymbolList list;
  list.add("A", kOperation, 65'500);
  const auto map = link::modbus::make_io_map(list.tables(), 0, {});
  CHECK_FALSE(map.status_block);
  CHECK(map.no_room_for_status);
  CHECK(map.faults.empty());

  LinkSettings small;
  small.sizes[kInput] = 64;
  const auto sized = link::modbus::make_io_map(SymbolList().tables(), 0, small);
  CHECK_FALSE(sized.status_block);
  CHECK(sized.no_room_for_status);
}

TEST_CASE("Status block and watchdog are at their given numbers, or absent") {
  SymbolList list;
  list.add("A", kEvent, 3, DataType::int_);
  LinkSettings settings;
  settings.status_block = 4;
  settings.watchdog = 9;
  const auto map = link::modbus::make_io_map(list.tables(), 0, settings);
  CHECK(map.status_block == 4);
  CHECK(map.watchdog == 9);
  CHECK(map.sizes[kInput] == 16);
  CHECK(map.sizes[kHolding] == 16);

  settings.status_block = link::kNowhere;
  settings.watchdog = link::kNowhere;
  const auto bare = link::modbus::make_io_map(list.tables(), 0, settings);
  CHECK_FALSE(bare.status_block);
  CHECK_FALSE(bare.no_room_for_status);
  CHECK_FALSE(bare.watchdog);
  CHECK(bare.sizes[kHolding] == 0);
}

TEST_CASE("A status block or watchdog that overlaps a symbol is a fault") {
  SymbolList list;
  list.add("SPEED", kEvent, 5, DataType::dint);  // 10 and 11
  list.add("MODE", kOperation, 3, DataType::int_);
  LinkSettings settings;
  settings.status_block = 0;
  CHECK(faults(list, settings) == Texts{"the status block from input register 0 on overlaps `SPEED` on input "
                                        "registers 10 to 11: give `status` another register, or `\"off\"`"});
  settings.status_block = 12;
  settings.watchdog = 3;
  CHECK(faults(list, settings) == Texts{"the watchdog on holding register 3 overlaps `MODE` on holding "
                                        "register 3: give `watchdog` another register"});
}

TEST_CASE("A status block or watchdog outside its table is a fault") {
  LinkSettings settings;
  settings.status_block = 65'525;
  CHECK(faults(SymbolList(), settings) == Texts{"the status block has 12 registers and does not fit from input "
                                                "register 65525 on, since the last one is 65535: "
                                                "give `status` a lower register, or `\"off\"`"});
  settings.status_block = 65'524;
  CHECK(faults(SymbolList(), settings).empty());
  settings.sizes[kHolding] = 32;
  settings.watchdog = 32;
  CHECK(faults(SymbolList(), settings) == Texts{"the watchdog is on holding register 32, but the last one is 31: "
                                                "give `watchdog` a lower register"});
}

TEST_CASE("Two symbols that overlap are a fault that names both") {
  SymbolList list;
  list.add("SPEED", kOperation, 5, DataType::dint);  // 10 and 11
  list.add("MODE", kOperation, 11, DataType::int_);
  list.add("OTHER", kEvent, 11, DataType::int_);  // in another table
  CHECK(faults(list) == Texts{"`SPEED` on holding registers 10 to 11 and `MODE` on holding register 11 overlap: "
                              "give one of them another number, in the list or in `links`"});
}

TEST_CASE("One address with two types of one size is valid, but not two addresses with one given number") {
  SymbolList list;
  list.add("A", kOperation, 5, DataType::int_);
  list.add("B", kOperation, 5, DataType::word);
  CHECK(faults(list).empty());
  list.add("C", kOperation, 6, DataType::word);
  const std::array<MapRow, 1> rows{{{2, 5}}};
  LinkSettings settings;
  settings.rows = rows;
  REQUIRE(faults(list, settings).size() == 1);
  CHECK(faults(list, settings)[0].starts_with("`A` on holding register 5 and `C` on holding register 5 overlap: "));
}

TEST_CASE("A symbol that ends after the last number, or outside the given table size, is a fault") {
  SymbolList list;
  list.add("A", kOperation, AddressForm::none, 0, DataType::dint);
  const std::array<MapRow, 1> rows{{{0, 65'535}}};
  LinkSettings settings;
  settings.rows = rows;
  CHECK(faults(list, settings) ==
        Texts{"`A` would end above address 65535, the highest in Modbus: give it a lower number"});
  SymbolList sized;
  sized.add("B", kOperation, 20);
  LinkSettings small;
  small.sizes[kCoils] = 20;
  CHECK(faults(sized, small) == Texts{"`B` is on coil 20, but the coils have the size 20: give them a larger "
                                      "`size`, or the symbol a lower number"});
  small.sizes[kCoils] = 21;
  CHECK(faults(sized, small).empty());
  CHECK(link::modbus::make_io_map(sized.tables(), 0, small).sizes[kCoils] == 21);
}

TEST_CASE("Symbols with given numbers keep them, and a packed table fills the gaps") {
  SymbolList list;
  list.add("A", kOperation, AddressForm::other, 0, DataType::int_);
  list.add("B", kOperation, AddressForm::other, 0, DataType::dint);
  list.add("C", kOperation, 7, DataType::int_);
  list.add("D", kOperation, AddressForm::none, 0, DataType::int_);
  const std::array<MapRow, 1> rows{{{3, 2}}};
  LinkSettings settings;
  settings.rows = rows;
  const auto map = link::modbus::make_io_map(list.tables(), 0, settings);
  CHECK(numbers(map) == std::vector<int>{0, 3, 5, 2});  // B takes 3 and 4, since D is at 2
  CHECK(map.packed[kHolding]);
  CHECK(map.faults.empty());
  CHECK(map.without_address.empty());
}

TEST_CASE("A number for the only symbol without one keeps its table from being packed") {
  SymbolList list;
  list.add("A", kOperation, AddressForm::other);
  list.add("B", kOperation, 7);
  const std::array<MapRow, 1> rows{{{0, 3}}};
  LinkSettings settings;
  settings.rows = rows;
  CHECK(numbers(link::modbus::make_io_map(list.tables(), 0, settings)) == std::vector<int>{3, 7});
}

TEST_CASE("Word order and on-loss are those of the link, or of the symbol") {
  SymbolList list;
  list.add("A", kOperation, 5, DataType::dint);
  list.add("B", kOperation, 6, DataType::dint);
  const std::array<MapRow, 1> rows{{{1, MapRow::kDefault, WordOrder::low_first, link::OnLoss::zero}}};
  LinkSettings settings;
  settings.rows = rows;
  settings.word_order = WordOrder::high_first;
  const auto map = link::modbus::make_io_map(list.tables(), 0, settings);
  CHECK(map.points[0].word_order == WordOrder::high_first);
  CHECK(map.points[0].on_loss == link::OnLoss::hold);
  CHECK(map.points[1].word_order == WordOrder::low_first);
  CHECK(map.points[1].on_loss == link::OnLoss::zero);
  CHECK(numbers(map) == std::vector<int>{10, 12});
}

TEST_CASE("The digest of a map changes with all that a PLC program depends on, and with nothing else") {
  struct Wanted {
    std::string_view name = "SPEED";
    std::uint32_t number = 5;
    DataType type = DataType::dint;
    tables::Direction direction = kOperation;
    LinkSettings settings = {};
  };
  const auto hash = [](const Wanted& wanted, bool reversed = false) {
    SymbolList list;
    if (reversed) list.add("LAMP", kOperation, 1);
    list.add(wanted.name, wanted.direction, wanted.number, wanted.type);
    if (!reversed) list.add("LAMP", kOperation, 1);
    return link::modbus::map_hash(list.tables(), link::modbus::make_io_map(list.tables(), 0, wanted.settings));
  };
  const std::uint64_t before = hash({});
  CHECK(before == hash({}));
  CHECK(before == hash({}, true));
  CHECK(before == hash({.name = "Speed"}));
  CHECK(before != hash({.name = "SPEED2"}));
  CHECK(before != hash({.number = 6}));
  CHECK(before != hash({.type = DataType::udint}));
  CHECK(before != hash({.direction = kEvent}));
  CHECK(before != hash({.settings = {.word_order = WordOrder::low_first}}));
  CHECK(before != hash({.settings = {.sizes = {32, 0, 0, 0}}}));
  CHECK(before != hash({.settings = {.status_block = 300}}));
  CHECK(before != hash({.settings = {.status_block = link::kNowhere}}));
  CHECK(before != hash({.settings = {.watchdog = 2}}));
  CHECK(before == hash({.settings = {.on_loss = link::OnLoss::zero}}));
  CHECK(before == hash({.settings = {.loss_after = 7}}));
  // A word order does not matter for a number of one register.
  CHECK(hash({.type = DataType::int_}) ==
        hash({.type = DataType::int_, .settings = {.word_order = WordOrder::low_first}}));
}

TEST_CASE("The digest of a map orders several names at one number independently of case") {
  const auto hash = [](std::string_view one, std::string_view other) {
    SymbolList list;
    const std::uint32_t leader = list.add(one, kOperation, 1);
    list.share(list.add(other, kOperation, 1), leader);
    return link::modbus::map_hash(list.tables(), link::modbus::make_io_map(list.tables(), 0, {}));
  };
  CHECK(hash("A", "B") == hash("a", "B"));
  CHECK(hash("A", "B") == hash("B", "a"));
  CHECK(hash("A", "B") != hash("A", "C"));
}

TEST_CASE("The digest of known maps is the same in every version") {
  SymbolList list;
  list.add("A", kOperation, 0);
  list.add("B", kEvent, 2, DataType::real);
  CHECK(link::modbus::map_hash(list.tables(), link::modbus::make_io_map(list.tables(), 0, {})) ==
        0xB5CB'2135'57CB'D1C2);
}

TEST_CASE("The fields of the status block fill its registers one after the other") {
  std::uint32_t next = 0;
  for (const link::StatusField& field : link::kStatusFields) {
    CHECK(field.first == next);
    next += field.words;
  }
  CHECK(next == link::kStatusWords);
}
