// Numbers of several registers, in the bytes on the wire, in both word orders and directions.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "unit/link/image_bench.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using namespace symplant::link::image;
using namespace symplant::link::modbus;
using link::WordOrder;
using tables::DataType;
using test::Bytes;
using test::ImageBench;
using test::SymbolList;

namespace {

constexpr std::uint64_t signed_slot(std::int64_t value) { return static_cast<std::uint64_t>(value); }
std::uint64_t real_slot(double value) { return std::bit_cast<std::uint64_t>(value); }

/// A number in the plant, and its registers with the high word first.
struct Sample {
  DataType type;
  std::uint64_t slot;
  std::vector<std::uint16_t> high_first;
};

std::vector<Sample> samples() {
  constexpr std::int64_t kLintMin = std::numeric_limits<std::int64_t>::min();
  return {
      {DataType::int_, signed_slot(-2), {0xFFFE}},
      {DataType::uint, 0xFFFE, {0xFFFE}},
      {DataType::word, 0x8001, {0x8001}},
      {DataType::dint, 0x0102'0304, {0x0102, 0x0304}},
      {DataType::dint, signed_slot(-2), {0xFFFF, 0xFFFE}},
      {DataType::dint, signed_slot(std::numeric_limits<std::int32_t>::min()), {0x8000, 0x0000}},
      {DataType::udint, 0x8000'0001, {0x8000, 0x0001}},
      {DataType::dword, 0xDEAD'BEEF, {0xDEAD, 0xBEEF}},
      {DataType::real, real_slot(1.5), {0x3FC0, 0x0000}},
      {DataType::real, real_slot(-0.1F), {0xBDCC, 0xCCCD}},
      {DataType::real, real_slot(std::numeric_limits<double>::infinity()), {0x7F80, 0x0000}},
      {DataType::real, real_slot(std::numeric_limits<double>::quiet_NaN()), {0x7FC0, 0x0000}},
      {DataType::lint, 0x0102'0304'0506'0708, {0x0102, 0x0304, 0x0506, 0x0708}},
      {DataType::lint, signed_slot(-3), {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFD}},
      {DataType::lint, signed_slot(kLintMin), {0x8000, 0, 0, 0}},
      {DataType::ulint, 0xFEDC'BA98'7654'3210, {0xFEDC, 0xBA98, 0x7654, 0x3210}},
      {DataType::lword, 1, {0, 0, 0, 1}},
      {DataType::lreal, real_slot(-0.1), {0xBFB9, 0x9999, 0x9999, 0x999A}},
      {DataType::lreal, real_slot(std::numeric_limits<double>::quiet_NaN()), {0x7FF8, 0, 0, 0}},
  };
}

/// The number's registers as bytes in a telegram.
Bytes wire(const Sample& sample, WordOrder order) {
  std::vector<std::uint16_t> registers = sample.high_first;
  if (order == WordOrder::low_first) std::reverse(registers.begin(), registers.end());
  Bytes bytes;
  for (const std::uint16_t value : registers) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
  }
  return bytes;
}

Bytes with(Bytes head, const Bytes& data) {
  head.insert(head.end(), data.begin(), data.end());
  return head;
}

}  // namespace

TEST_CASE("A number written in one request reaches the plant complete, for every type and word order") {
  const WordOrder order = GENERATE(WordOrder::low_first, WordOrder::high_first);
  for (const Sample& sample : samples()) {
    INFO("type " << int(sample.type) << ", slot " << sample.slot);
    SymbolList list;
    list.add("BEFORE", SymbolList::kOut, 2, DataType::int_);
    list.add("NUMBER", SymbolList::kOut, tables::AddressForm::none, 0, sample.type);
    const std::array<link::MapRow, 1> rows{{{1, 3, order}}};  // registers 3 and 4 lie in different words
    ImageBench bench(list.tables(), {.rows = rows});
    const Bytes data = wire(sample, order);
    const auto count = static_cast<std::uint8_t>(data.size() / 2);
    CHECK(bench.ask(with({16, 0, 3, 0, count, static_cast<std::uint8_t>(2 * count)}, data)) ==
          Bytes{16, 0, 3, 0, count});
    bench.cycle();
    CHECK(bench.plant->operation_value(1) == sample.slot);
    CHECK(bench.plant->operation_value(0) == 0);
    CHECK(bench.gaps == 0);
    CHECK(bench.ask({3, 0, 3, 0, count}) == with({3, static_cast<std::uint8_t>(2 * count)}, data));
  }
}

TEST_CASE("The plant's numbers are in their registers, for every type and word order") {
  const WordOrder order = GENERATE(WordOrder::low_first, WordOrder::high_first);
  for (const Sample& sample : samples()) {
    INFO("type " << int(sample.type) << ", slot " << sample.slot);
    SymbolList list;
    list.add("BEFORE", SymbolList::kIn, 2, DataType::int_);
    list.add("NUMBER", SymbolList::kIn, tables::AddressForm::none, 0, sample.type);
    list.add("AFTER", SymbolList::kIn, 7, DataType::int_);
    const std::array<link::MapRow, 1> rows{{{1, 3, order}}};
    ImageBench bench(list.tables(), {.rows = rows});
    bench.plant->set_input(1, sample.slot);
    bench.plant->set_input(2, 5);
    bench.cycle();
    const Bytes data = wire(sample, order);
    const auto count = static_cast<std::uint8_t>(data.size() / 2);
    CHECK(bench.ask({4, 0, 3, 0, count}) == with({4, static_cast<std::uint8_t>(2 * count)}, data));
    CHECK(bench.ask({4, 0, 2, 0, 1}) == Bytes{4, 2, 0, 0});
    CHECK(bench.ask({4, 0, 7, 0, 1}) == Bytes{4, 2, 0, 5});
  }
}

TEST_CASE("Numbers start at their initial value in all of their registers") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, 1, DataType::dint);
  list.add("LEVEL", SymbolList::kIn, 1, DataType::real);
  list.start_at(0, signed_slot(-5));
  list.start_at(1, real_slot(1.5));
  ImageBench bench(list.tables(), {.word_order = WordOrder::low_first});
  CHECK(bench.ask({3, 0, 2, 0, 2}) == Bytes{3, 4, 0xFF, 0xFB, 0xFF, 0xFF});
  CHECK(bench.ask({4, 0, 2, 0, 2}) == Bytes{4, 4, 0, 0, 0x3F, 0xC0});
}

TEST_CASE("A number written one register at a time has its intermediate value in each cycle") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, 0, DataType::dint);
  ImageBench bench(list.tables());
  bench.ask({6, 0, 1, 0, 7});
  bench.cycle();
  CHECK(bench.plant->operation_value(0) == 7);
  bench.ask({6, 0, 0, 0xFF, 0xFF});
  bench.cycle();
  CHECK(bench.plant->operation_value(0) == signed_slot(-65'529));
}

TEST_CASE("Symbols of one address and size read the same registers with their own type") {
  SymbolList list;
  list.add("A", SymbolList::kOut, 3, DataType::dint);
  list.add("B", SymbolList::kOut, 3, DataType::udint);
  list.add("C", SymbolList::kOut, 3, DataType::real);
  ImageBench bench(list.tables());
  bench.ask({16, 0, 6, 0, 2, 4, 0xBF, 0x80, 0, 0});
  bench.cycle();
  CHECK(bench.plant->operation_value(0) == signed_slot(static_cast<std::int32_t>(0xBF80'0000)));
  CHECK(bench.plant->operation_value(1) == 0xBF80'0000);
  CHECK(bench.plant->operation_value(2) == real_slot(-1));
}

TEST_CASE("A number of 8 bits is in the lower half of its register") {
  SymbolList list;
  list.add("A", SymbolList::kOut, tables::AddressForm::none, 0, DataType::sint);
  list.add("B", SymbolList::kOut, tables::AddressForm::none, 0, DataType::byte);
  list.add("C", SymbolList::kIn, tables::AddressForm::none, 0, DataType::sint);
  const std::array<link::MapRow, 3> rows{{{0, 0}, {1, 1}, {2, 0}}};
  ImageBench bench(list.tables(), {.rows = rows});
  bench.ask({16, 0, 0, 0, 2, 4, 0x00, 0xFE, 0x12, 0xFE});
  bench.plant->set_input(2, signed_slot(-3));
  bench.cycle();
  CHECK(bench.plant->operation_value(0) == signed_slot(-2));
  CHECK(bench.plant->operation_value(1) == 0xFE);
  CHECK(bench.ask({4, 0, 0, 0, 1}) == Bytes{4, 2, 0xFF, 0xFD});
}
