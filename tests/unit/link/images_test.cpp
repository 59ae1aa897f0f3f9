// The images between a Modbus server and a plant, without a socket.
#include "symplant/link/image/images.hpp"

#include "support/catch.hpp"
#include "unit/exec/cell.hpp"
#include "unit/link/image_bench.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using namespace symplant::link::image;
using namespace symplant::link::modbus;
using tables::DataType;
using test::Bytes;
using test::ImageBench;
using test::SymbolList;

TEST_CASE("A server drives the paper's cell by coils and reads it by discrete inputs") {
  ImageBench bench(test::cell_tables());
  CHECK(bench.ask({2, 0, 1, 0, 4}) == Bytes{2, 1, 0b0101});
  CHECK(bench.ask({5, 0, 1, 0xFF, 0}) == Bytes{5, 0, 1, 0xFF, 0});
  CHECK(bench.ask({1, 0, 1, 0, 4}) == Bytes{1, 1, 0b0001});
  CHECK(bench.ask({2, 0, 1, 0, 4}) == Bytes{2, 1, 0b0101});  // no cycle yet
  bench.cycle();
  CHECK(bench.plant->operation(test::cell::kAgvToP2));
  CHECK(bench.ask({2, 0, 1, 0, 4}) == Bytes{2, 1, 0b0100});
  bench.cycle(tables::kSecond);
  CHECK(bench.ask({2, 0, 1, 0, 4}) == Bytes{2, 1, 0b0110});
  CHECK(bench.ask({15, 0, 1, 0, 4, 1, 0b1000}) == Bytes{15, 0, 1, 0, 4});
  bench.cycle();
  CHECK_FALSE(bench.plant->operation(test::cell::kAgvToP2));
  CHECK(bench.plant->operation(test::cell::kMachineToRun2));
  CHECK(bench.gaps == 0);
}

TEST_CASE("Gaps read 0 until written, keep written values, and are counted") {
  ImageBench bench(test::cell_tables());
  CHECK(bench.ask({1, 0, 0, 0, 16}) == Bytes{1, 2, 0, 0});
  bench.ask({15, 0, 0, 0, 16, 2, 0xFF, 0xFF});
  CHECK(bench.gaps == 11);  // coil 0 is in the transfer range
  CHECK(bench.ask({1, 0, 0, 0, 16}) == Bytes{1, 2, 0xFF, 0xFF});
  bench.cycle();
  CHECK(bench.plant->operations()[0] == 0b1111);
  CHECK(bench.ask({2, 0, 0, 0, 16})[2] % 2 == 0);
}

TEST_CASE("There is no address above the rounded size") {
  ImageBench bench(test::cell_tables());
  CHECK(bench.ask({1, 0, 0, 0, 17}) == Bytes{0x81, 2});
  CHECK(bench.ask({5, 0, 16, 0xFF, 0}) == Bytes{0x85, 2});
  CHECK(bench.ask({3, 0, 0, 0, 1}) == Bytes{0x83, 2});
}

TEST_CASE("A coil of several operations writes them all") {
  SymbolList list;
  const std::uint32_t first = list.add("A", SymbolList::kOut, 5);
  list.share(list.add("B", SymbolList::kOut, 5), first);
  list.add("C", SymbolList::kOut, 6);
  ImageBench bench(list.tables());
  bench.ask({5, 0, 5, 0xFF, 0});
  bench.cycle();
  CHECK(bench.plant->operations()[0] == 0b011);
  bench.ask({5, 0, 5, 0, 0});
  bench.cycle();
  CHECK(bench.plant->operations()[0] == 0);
}

TEST_CASE("Numbers at one register start at the value of the leading one, and another type gets a separate reading") {
  SymbolList list;
  const std::uint32_t first = list.add("A", SymbolList::kOut, 3, DataType::int_);
  list.share(list.add("B", SymbolList::kOut, 3, DataType::int_), first);
  list.add("W", SymbolList::kOut, 3, DataType::word);
  list.start_at(first, 7);
  ImageBench bench(list.tables());
  CHECK(bench.ask({3, 0, 3, 0, 1}) == Bytes{3, 2, 0, 7});
  CHECK(bench.plant->operation_value(1) == 7);
  bench.ask({6, 0, 3, 0xFF, 0xFE});
  bench.cycle();
  CHECK(static_cast<std::int64_t>(bench.plant->operation_value(0)) == -2);
  CHECK(static_cast<std::int64_t>(bench.plant->operation_value(1)) == -2);
  CHECK(bench.plant->operation_value(2) == 0xFFFE);
}

TEST_CASE("Holding registers reach the plant as numbers of their type") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, 3, DataType::int_);
  list.add("MASK", SymbolList::kOut, 4, DataType::word);
  list.add("COUNT", SymbolList::kOut, 9, DataType::uint);
  ImageBench bench(list.tables());
  bench.ask({16, 0, 3, 0, 2, 4, 0xFF, 0xFE, 0xFF, 0xFE});
  bench.ask({6, 0, 9, 0x80, 0x00});
  bench.cycle();
  CHECK(static_cast<std::int64_t>(bench.plant->operation_value(0)) == -2);
  CHECK(bench.plant->operation_value(1) == 0xFFFE);
  CHECK(bench.plant->operation_value(2) == 0x8000);
  CHECK(bench.ask({3, 0, 3, 0, 2}) == Bytes{3, 4, 0xFF, 0xFE, 0xFF, 0xFE});
  bench.ask({16, 0, 7, 0, 4, 8, 0, 1, 0, 1, 0, 1, 0, 1});
  CHECK(bench.gaps == 1);
}

TEST_CASE("Numbers start at their initial value on both sides, and zero can overwrite it") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, 2, DataType::int_);
  list.add("LEVEL", SymbolList::kIn, 7, DataType::int_);
  list.add("LAMP", SymbolList::kIn, 3);
  list.start_at(0, static_cast<std::uint64_t>(std::int64_t{-5}));
  list.start_at(1, 300);
  list.start_at(2, 1);
  ImageBench bench(list.tables());
  CHECK(bench.ask({3, 0, 2, 0, 1}) == Bytes{3, 2, 0xFF, 0xFB});
  CHECK(bench.ask({4, 0, 7, 0, 1}) == Bytes{4, 2, 0x01, 0x2C});
  CHECK(bench.ask({2, 0, 3, 0, 1}) == Bytes{2, 1, 1});
  CHECK(static_cast<std::int64_t>(bench.plant->operation_value(0)) == -5);
  bench.ask({6, 0, 2, 0, 0});
  bench.cycle();
  CHECK(bench.plant->operation_value(0) == 0);
}

TEST_CASE("Distant addresses, in every word of the image, reach the plant and come back") {
  SymbolList list;
  for (std::uint32_t i = 0; i < 1000; ++i) list.add("O", SymbolList::kOut, i * 65);
  ImageBench bench(list.tables());
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto address = static_cast<std::uint16_t>(i * 65);
    bench.ask({5, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address & 0xFF), 0xFF, 0});
    if (i % 7 == 0) bench.cycle();
  }
  bench.cycle();
  std::uint32_t on = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) on += bench.plant->operation(i) ? 1U : 0U;
  CHECK(on == 1000);
  CHECK(bench.gaps == 0);
}

TEST_CASE("The coil of an inverted operation is on at the start and after a loss, and its first write counts") {
  SymbolList list;
  list.invert(list.add("A", SymbolList::kOut, 0));
  list.add("B", SymbolList::kOut, 1);
  link::LinkSettings settings;
  settings.on_loss = link::OnLoss::zero;
  ImageBench bench(list.tables(), settings);
  CHECK(bench.ask({1, 0, 0, 0, 2}) == Bytes{1, 1, 0b01});
  CHECK(bench.plant->operations()[0] == 0b01);
  bench.ask({15, 0, 0, 0, 2, 1, 0b10});  // commands A, since its bit is off, and B
  bench.cycle();
  CHECK(bench.plant->operations()[0] == 0b10);
  bench.images.zero_operations(*bench.plant);
  bench.plant->advance_to(bench.time += 1);
  CHECK(bench.plant->operations()[0] == 0b01);
}

TEST_CASE("The discrete input of an inverted event is on while the event is off") {
  SymbolList list;
  const std::uint32_t row = list.add("E", SymbolList::kIn, 0);
  list.invert(row);
  list.start_at(row, 1);  // as a unit would see it: its bit starts off
  list.invert(list.add("F", SymbolList::kIn, 1));
  ImageBench bench(list.tables());
  CHECK(bench.ask({2, 0, 0, 0, 2}) == Bytes{2, 1, 0b10});
  bench.plant->set_input(row, 1);
  bench.cycle();
  CHECK(bench.ask({2, 0, 0, 0, 2}) == Bytes{2, 1, 0b11});
  bench.plant->force(row, 0);
  bench.cycle();
  CHECK(bench.ask({2, 0, 0, 0, 2}) == Bytes{2, 1, 0b10});
}
