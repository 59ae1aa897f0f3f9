// Where symbols lie in the memory of a PLC.
#include "symplant/link/slmp/map.hpp"

#include <array>

#include "support/catch.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using namespace symplant::link::slmp;
using Catch::Matchers::ContainsSubstring;
using test::SymbolList;

namespace {

using Made = std::variant<DeviceMap, link::LinkError>;

Made make(const SymbolList& list, const std::string& parameters) {
  const auto read = read_settings("//10.0.0.5:5000?" + parameters);
  if (const auto* error = std::get_if<link::LinkError>(&read)) FAIL(error->message);
  return make_device_map(list.tables(), 0, {}, std::get<Settings>(read));
}

DeviceMap map_of(const SymbolList& list, const std::string& parameters) {
  Made made = make(list, parameters);
  if (const auto* error = std::get_if<link::LinkError>(&made)) FAIL(error->message);
  return std::get<DeviceMap>(std::move(made));
}

std::string fault(const SymbolList& list, const std::string& parameters) {
  const Made made = make(list, parameters);
  const auto* const error = std::get_if<link::LinkError>(&made);
  return error == nullptr ? "" : error->message;
}

/// "X10 Y20 D5": the devices in the order of the symbols.
std::string devices(const DeviceMap& map, Family family = Family::q) {
  std::string text;
  for (const Device& device : map.devices) text += (text.empty() ? "" : " ") + device_text(device, family);
  return text;
}

constexpr auto kIn = SymbolList::kIn;
constexpr auto kOut = SymbolList::kOut;

}  // namespace

TEST_CASE("The low word of a number is first, whatever the list has, unless the plant sets another order") {
  SymbolList list;
  list.add_device("A", kOut, "D100", tables::DataType::real);
  list.add_device("B", kOut, "D102", tables::DataType::real);
  const std::array<link::MapRow, 1> rows{link::MapRow{.symbol = 1, .word_order = link::WordOrder::high_first}};
  const auto orders = [&](const link::LinkSettings& link) {
    const auto made = make_device_map(list.tables(), 0, link, std::get<Settings>(read_settings("//h:5000?family=q")));
    const auto& orders_of_points = std::get<DeviceMap>(made).word_orders;
    return std::pair(orders_of_points[0], orders_of_points[1]);
  };
  constexpr auto kLow = link::WordOrder::low_first;
  constexpr auto kHigh = link::WordOrder::high_first;
  CHECK(orders({.word_order = kHigh}) == std::pair(kLow, kLow));
  CHECK(orders({.rows = rows, .word_order = kHigh}) == std::pair(kLow, kHigh));
  CHECK(orders({.word_order = kHigh, .word_order_given = true}) == std::pair(kHigh, kHigh));
}

TEST_CASE("Without a choice for events at X there is no map") {
  SymbolList list;
  list.add_device("A", kIn, "X10", 16);
  CHECK_THAT(fault(list, "family=q"),
             ContainsSubstring("`A` is at X10") && ContainsSubstring("events=direct") && ContainsSubstring("map="));
  CHECK(devices(map_of(list, "family=q&events=direct")) == "X10");
  CHECK(devices(map_of(list, "family=q&events=dx")) == "DX10");
  CHECK(devices(map_of(list, "family=q&map=X0-X1F:X800")) == "X810");
  CHECK(devices(map_of(list, "family=q&map=X0-X1F:M100")) == "M116");
  CHECK(devices(map_of(list, "family=q&map=X0-X1F:D100")) == "D101.0");
  CHECK(devices(map_of(list, "family=q&map=X8-X1F:D100.C")) == "D101.4");
  CHECK(devices(map_of(list, "family=q&map=A:B5")) == "B5");
  CHECK_THAT(fault(list, "family=q&map=X0-XF:M0"), ContainsSubstring("events=direct"));
  CHECK_THAT(fault(list, "family=q&events=direct&map=B:M0"), ContainsSubstring("`B`, which is not a symbol"));
}

TEST_CASE("Operations need no choice, and events never go to outputs") {
  SymbolList list;
  list.add_device("A", kOut, "Y20", 32);
  list.add_device("B", kOut, "D100.F");
  list.add_device("C", kOut, "D7", tables::DataType::dint);
  CHECK(devices(map_of(list, "family=q")) == "Y20 D100.F D7");
  SymbolList wrong;
  wrong.add_device("W", kIn, "Y5", 5);
  CHECK_THAT(fault(wrong, "family=q&events=direct"),
             ContainsSubstring("`W` is an event at Y5") && ContainsSubstring("never written"));
}

TEST_CASE("Images hold 16 bits of a word together, and each number at one position, in list order") {
  SymbolList list;
  list.add_device("A", kOut, "Y2F", 0x2F);
  list.add_device("B", kOut, "Y1", 1);
  list.add_device("C", kOut, "D8", tables::DataType::dint);
  list.add_device("D", kOut, "D5", tables::DataType::word);
  list.add_device("E", kIn, "M100.0");
  list.add_device("F", kIn, "M100");
  const DeviceMap map = map_of(list, "family=q");
  CHECK(map.operations.bits == std::vector<Cell>{{*kind_of("Y"), 0}, {*kind_of("Y"), 2}});
  std::vector<std::uint32_t> words;
  for (const link::slmp::NumberCell& number : map.operations.numbers) words.push_back(number.cell.word);
  CHECK(words == std::vector<std::uint32_t>{5, 8, 9});
  REQUIRE(map.image.points.size() == 5);
  CHECK(map.image.points[0].position == 16 + 15);
  CHECK(map.image.points[1].position == 1);
  CHECK(map.image.points[2].position == 0);
  CHECK(map.image.points[3].position == 1);
  CHECK(map.image.points[4].position == 100 % 16);
  REQUIRE(map.unreachable.size() == 1);
  CHECK_THAT(map.unreachable[0].reason, ContainsSubstring("not a device"));
}

TEST_CASE("A symbol whose type does not fit its device is not linked") {
  SymbolList list;
  list.add_device("A", kOut, "D100");
  list.add_device("B", kOut, "M5", tables::DataType::int_);
  list.add_device("C", kOut, "K4Y10", tables::DataType::int_);
  list.add_device("D", kOut, "K4Y10", tables::DataType::dint);
  list.add_device("E", kOut, "K4Y8", tables::DataType::int_);
  list.add_device("F", kOut, "");
  const DeviceMap map = map_of(list, "family=q");
  CHECK(devices(map) == "K4Y10");
  REQUIRE(map.unreachable.size() == 5);
  CHECK_THAT(map.unreachable[0].reason, ContainsSubstring("D100, which has 16 bits"));
  CHECK_THAT(map.unreachable[1].reason, ContainsSubstring("M5, which is a bit"));
  CHECK_THAT(map.unreachable[2].reason, ContainsSubstring("32 bits at K4Y10"));
  CHECK_THAT(map.unreachable[3].reason, ContainsSubstring("multiple of 16"));
  CHECK_THAT(map.unreachable[4].reason, ContainsSubstring("no address"));
}

TEST_CASE("Two symbols of different addresses or directions cannot have one location") {
  SymbolList bits;
  bits.add_device("A", kIn, "X0", 0);
  bits.add_device("B", kIn, "X10", 16);
  CHECK_THAT(fault(bits, "family=q&map=X0:M5&map=X10:M5"),
             ContainsSubstring("`A` on M5 and `B` on M5") || ContainsSubstring("overlap"));
  SymbolList word;
  word.add_device("A", kIn, "D5.0");
  word.add_device("B", kOut, "D5.1");
  CHECK_THAT(fault(word, "family=q"), ContainsSubstring("share a word"));
  SymbolList number;
  number.add_device("A", kIn, "D5", tables::DataType::dint);
  number.add_device("B", kIn, "D6", tables::DataType::int_);
  CHECK_THAT(fault(number, "family=q"), ContainsSubstring("`A` on D5 and `B` on D6 overlap"));
  SymbolList same;
  same.add_device("A", kOut, "Y5", 5);
  same.add_device("B", kOut, "Y5", 5);
  CHECK(devices(map_of(same, "family=q")) == "Y5 Y5");
}

TEST_CASE("A group of bits that is moved to words is the words in which its bits are") {
  SymbolList list;
  list.add_device("A", kOut, "Y51", 0x51);
  list.add_device("B", kOut, "K4Y40", tables::DataType::word);
  list.add_device("C", kOut, "K8Y60", tables::DataType::dint);
  CHECK(devices(map_of(list, "family=q&map=Y0-Y7F:W5")) == "WA.1 W9 WB");
  CHECK(devices(map_of(list, "family=q&map=Y0-Y7F:M16")) == "M97 K4M80 K8M112");
  const DeviceMap apart = map_of(list, "family=q&map=Y0-Y7F:W5.4");
  CHECK(devices(apart) == "WA.5");
  CHECK_THAT(apart.unreachable.front().reason, ContainsSubstring("is a number at W9.4"));
  SymbolList wide;
  wide.add_device("A", kOut, "K4Y40", tables::DataType::dint);
  CHECK_THAT(map_of(wide, "family=q&map=Y0-Y7F:W5").unreachable.front().reason, ContainsSubstring("32 bits at K4Y40"));
}

TEST_CASE("A symbol beyond the devices that a request can name is refused") {
  SymbolList bits;
  bits.add_device("A", kIn, "X0", 0);
  bits.add_device("B", kIn, "X1", 1);
  CHECK_THAT(fault(bits, "family=q&map=X0-X1:M16777215"), ContainsSubstring("`B` is at M16777216, beyond the devices"));
  CHECK(devices(map_of(bits, "family=q&map=X0-X1:M16777214")) == "M16777214 M16777215");
  SymbolList wide;
  wide.add_device("A", kOut, "D16777213", tables::DataType::lreal);
  CHECK_THAT(fault(wide, "family=q"), ContainsSubstring("`A` is at D16777213, beyond"));
  CHECK(fault(wide, "family=q&map=A:D16777212").empty());
}

TEST_CASE("A list with X counted otherwise than the family is refused") {
  SymbolList list;
  list.add_device("A", kOut, "Y10", 16);
  CHECK_THAT(fault(list, "family=fx5"), ContainsSubstring("read with hexadecimal") && ContainsSubstring("--xy octal"));
  CHECK(devices(map_of(list, "family=iqr"), Family::iqr) == "Y10");
  SymbolList octal;
  octal.add_device("A", kOut, "Y10", 8);
  CHECK(devices(map_of(octal, "family=fx5"), Family::fx5) == "Y10");
}
