// Random maps: every mapped event is written once and no other address, and all operations are read.
#include <algorithm>
#include <map>
#include <random>

#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "unit/modbus/dialog_bench.hpp"
#include "unit/modbus/draw.hpp"

using namespace symplant;
using link::modbus::Table;
using tables::DataType;
using test::DialogBench;
using test::draw;
using test::SymbolList;
using test::modbus::ModbusPlc;
using test::modbus::PlcArea;
using test::modbus::PlcMemory;

namespace {

/// A number of a table, and how many registers it takes.
struct Numbered {
  std::uint32_t number;
  std::uint32_t width;
};

struct RandomMap {
  SymbolList list;
  std::vector<Numbered> bit_events;
  std::vector<Numbered> number_events;
  std::vector<Numbered> bit_operations;
  std::vector<Numbered> number_operations;
};

std::vector<Numbered> add_random(SymbolList& list, std::mt19937& random, tables::Direction direction, bool bits) {
  const std::uint32_t spread = 1 + draw(random, 5);
  const std::string prefix = std::string(direction == SymbolList::kIn ? "I" : "O") + (bits ? "B" : "N");
  std::vector<Numbered> numbers;
  std::uint32_t at = draw(random, 8);
  for (std::uint32_t i = draw(random, 100); i > 0 && at < 450; --i) {
    const std::uint32_t width = bits ? 1 : 1 + draw(random, 2);
    at += at % width;
    const DataType type = bits ? DataType::boolean : (width == 1 ? DataType::int_ : DataType::dint);
    list.add(prefix + std::to_string(at), direction, at / width, type);
    numbers.push_back({at, width});
    at += width + draw(random, spread);
  }
  return numbers;
}

RandomMap random_map(std::mt19937& random) {
  RandomMap map;
  map.bit_events = add_random(map.list, random, SymbolList::kIn, true);
  map.number_events = add_random(map.list, random, SymbolList::kIn, false);
  map.bit_operations = add_random(map.list, random, SymbolList::kOut, true);
  map.number_operations = add_random(map.list, random, SymbolList::kOut, false);
  return map;
}

/// Fills the inputs with random values, and removes some addresses that the map does not use.
void fill_inputs(PlcMemory& memory, std::mt19937& random) {
  for (auto& bit : memory.discrete_inputs) bit = static_cast<std::uint16_t>(draw(random, 2));
  for (auto& value : memory.input_registers) value = static_cast<std::uint16_t>(draw(random, 65'536));
}

void remove_unused(PlcMemory& memory, const RandomMap& map, std::mt19937& random) {
  for (int i = 0; i < 20; ++i) {
    const std::uint32_t number = draw(random, 460);
    const auto has = [&](const Numbered& one) { return number >= one.number && number < one.number + one.width; };
    if (std::none_of(map.bit_operations.begin(), map.bit_operations.end(), has)) {
      memory.holes.emplace(PlcArea::discrete_inputs, number + 7);
    }
    if (std::none_of(map.number_operations.begin(), map.number_operations.end(), has)) {
      memory.holes.emplace(PlcArea::input_registers, number + 9);
    }
  }
}

void check_reading(DialogBench& bench, const RandomMap& map, const PlcMemory& memory) {
  REQUIRE_FALSE(bench.read());
  for (const Numbered& one : map.bit_operations) {
    CHECK(bench.bit(one.number) == (memory.discrete_inputs[one.number + 7] != 0));
  }
  for (const Numbered& one : map.number_operations) {
    for (std::uint32_t k = 0; k < one.width; ++k) {
      CHECK(bench.number(one.number + k) == memory.input_registers[one.number + k + 9]);
    }
  }
}

/// How often each address may be written, from 0: 3 is the first register of packed events, 11 their first coil.
std::map<std::pair<PlcArea, std::size_t>, int> allowed_writes(const RandomMap& map, bool packed) {
  std::map<std::pair<PlcArea, std::size_t>, int> allowed;
  for (const Numbered& one : map.bit_events) {
    const std::size_t address = packed ? 3 + one.number / 16 : 11 + one.number;
    allowed[{packed ? PlcArea::holding_registers : PlcArea::coils, address}] = 0;
  }
  for (const Numbered& one : map.number_events) {
    for (std::uint32_t k = 0; k < one.width; ++k) allowed[{PlcArea::holding_registers, 500U + one.number + k}] = 0;
  }
  return allowed;
}

void check_writing(ModbusPlc& plc, DialogBench& bench, const RandomMap& map, bool packed) {
  REQUIRE_FALSE(bench.write());
  auto allowed = allowed_writes(map, packed);
  for (const auto& written : plc.written()) {
    for (std::size_t i = 0; i < written.values.size(); ++i) {
      const auto found = allowed.find({written.area, written.first + i});
      REQUIRE(found != allowed.end());
      ++found->second;
    }
  }
  CHECK(std::all_of(allowed.begin(), allowed.end(), [](const auto& one) { return one.second == 1; }));
  std::vector<std::uint64_t> bits(200);
  std::vector<std::uint64_t> numbers(200);
  REQUIRE_FALSE(bench.read_back(bits, numbers));
  CHECK(bench.outbox().differences({bits, numbers}).empty());
}

}  // namespace

TEST_CASE("Random maps: every mapped event is written once, no other address, and all operations are read") {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    const bool packed = draw(random, 2) == 0;
    CAPTURE(round, packed);
    const RandomMap map = random_map(random);
    PlcMemory memory;
    fill_inputs(memory, random);
    if (draw(random, 2) == 0) remove_unused(memory, map, random);
    ModbusPlc plc({.memory = memory});
    DialogBench bench(map.list, plc.port(),
                      std::string("operations=discrete-inputs:7&operation-values=input-registers:9&event-values="
                                  "holding-registers:500&events=") +
                          (packed ? "holding-registers:3" : "coils:11"));
    REQUIRE_FALSE(bench.dialog().open());
    check_reading(bench, map, memory);
    for (const Numbered& one : map.bit_events) bench.set_bit(one.number, draw(random, 2) == 0);
    for (const Numbered& one : map.number_events) {
      bench.set_number(one.number, static_cast<std::uint16_t>(draw(random, 65'536)));
    }
    check_writing(plc, bench, map, packed);
    // Then some of the events change.
    plc.forget_log();
    for (const Numbered& one : map.bit_events) {
      if (draw(random, 3) == 0) bench.set_bit(one.number, draw(random, 2) == 0);
    }
    REQUIRE_FALSE(bench.write());
    const auto allowed = allowed_writes(map, packed);
    for (const auto& written : plc.written()) {
      for (std::size_t i = 0; i < written.values.size(); ++i) {
        CHECK(allowed.count({written.area, written.first + i}) == 1);
      }
    }
    CHECK(bench.dialog().take_rejections().empty());
  }
}
