// A Modbus client against a PLC that lies: no wrong or old value, and no standstill.
#include <algorithm>
#include <cstdlib>

#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "unit/modbus/dialog_bench.hpp"

using namespace symplant;
using link::client::Fault;
using link::modbus::Table;
using test::DialogBench;
using test::SymbolList;
using test::modbus::Lie;
using test::modbus::Lies;
using test::modbus::ModbusPlc;
using test::modbus::PlcMemory;

namespace {

constexpr std::uint32_t kBits = 40;
constexpr std::uint32_t kNumbers = 20;
constexpr std::uint32_t kEventNumber = 3;

SymbolList versioned_list() {
  SymbolList list;
  for (std::uint32_t i = 0; i < kBits; ++i) list.add("B" + std::to_string(i), SymbolList::kOut, i);
  for (std::uint32_t i = 0; i < kNumbers; ++i) {
    list.add("N" + std::to_string(i), SymbolList::kOut, i, tables::DataType::word);
  }
  list.add("EVENT", SymbolList::kIn, kEventNumber, tables::DataType::word);
  return list;
}

bool bit_of(std::uint32_t version, std::uint32_t i) { return ((version * 2654435761U) >> (i % 32) & 1) != 0; }
std::uint16_t number_of(std::uint32_t version, std::uint32_t i) {
  return static_cast<std::uint16_t>(version * 40503U + i);
}

void set_version(PlcMemory& memory, std::uint32_t version) {
  for (std::uint32_t i = 0; i < kBits; ++i) memory.coils[i] = bit_of(version, i) ? 1 : 0;
  for (std::uint32_t i = 0; i < kNumbers; ++i) memory.holding_registers[i] = number_of(version, i);
}

/// The number of values that are not those of the version.
int wrong_values(DialogBench& bench, std::uint32_t version) {
  int wrong = 0;
  for (std::uint32_t i = 0; i < kBits; ++i) wrong += bench.bit(i) != bit_of(version, i) ? 1 : 0;
  for (std::uint32_t i = 0; i < kNumbers; ++i) {
    wrong += bench.number(i) != number_of(version, i) ? 1 : 0;
  }
  return wrong;
}

/// The campaign sets the number of lies by the environment; otherwise a short run.
std::uint64_t lies_wanted() {
  const char* const text = std::getenv("SYMPLANT_LIES");
  return text == nullptr ? 300 : std::strtoull(text, nullptr, 10);
}

struct Outcome {
  int wrong = 0;
  int wrong_writes = 0;
  std::uint64_t readings = 0;
};

/// Polls until the PLC has lied often enough. A reading without a fault must bring the values that the PLC has now.
Outcome poll_while_it_lies(ModbusPlc& plc, DialogBench& bench, std::uint64_t lies) {
  Outcome outcome;
  bool open = false;
  for (std::uint32_t version = 1; plc.lies() < lies; ++version) {
    plc.with([&](PlcMemory& memory) { set_version(memory, version); });
    if (!open && bench.dialog().open()) continue;
    Fault fault = bench.read();
    if (!fault) {
      ++outcome.readings;
      outcome.wrong += wrong_values(bench, version);
      bench.set_number(kEventNumber, static_cast<std::uint16_t>(version));
      fault = bench.write();
      if (!fault) {
        plc.with([&](PlcMemory& memory) {
          if (memory.holding_registers[500 + kEventNumber] != static_cast<std::uint16_t>(version)) {
            ++outcome.wrong_writes;
          }
        });
      }
    }
    open = !fault;
    if (!open) bench.dialog().close();
  }
  return outcome;
}

void survive(const Lies& lies, std::uint64_t count) {
  ModbusPlc plc;
  DialogBench bench(versioned_list(), plc.port(), "event-values=holding-registers:500&timeout=15ms");
  plc.lie(lies);
  const Outcome outcome = poll_while_it_lies(plc, bench, count);
  CHECK(outcome.wrong == 0);
  CHECK(outcome.wrong_writes == 0);
  CHECK(bench.dialog().take_rejections().empty());
  plc.lie({});
  plc.with([](PlcMemory& memory) { set_version(memory, 7); });
  bool recovered = false;
  for (int attempt = 0; attempt < 100 && !recovered; ++attempt) {  // a slow machine may exceed the short timeout
    bench.dialog().close();
    recovered = !bench.dialog().open() && !bench.read();
  }
  REQUIRE(recovered);
  CHECK(wrong_values(bench, 7) == 0);
  const auto written = plc.written();
  CHECK(std::all_of(written.begin(), written.end(),
                    [](const auto& one) { return one.first == 500 + kEventNumber && one.values.size() == 1; }));
}

}  // namespace

TEST_CASE("A lying Modbus server brings no wrong or old value and no standstill") {
  survive({.seed = 1, .per_thousand = 300}, lies_wanted());
}

TEST_CASE("Each lie of a Modbus server alone is survived") {
  for (int kind = 1; kind < test::modbus::kLies; ++kind) {
    CAPTURE(kind);
    survive({.seed = static_cast<std::uint32_t>(kind), .per_thousand = 500, .kinds = {static_cast<Lie>(kind)}}, 5);
  }
}

TEST_CASE("A frame that came before its request is not the reply, whatever its transaction id is") {
  ModbusPlc plc;
  SymbolList list;
  list.add("B0", SymbolList::kOut, 0);
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  plc.lie({.seed = 5, .per_thousand = 1000, .kinds = {Lie::early}});
  for (int i = 0; i < 600; ++i) {
    const Fault fault = bench.read();
    INFO(fault.message);
    REQUIRE_FALSE(fault);
    REQUIRE_FALSE(bench.bit(0));
  }
}

TEST_CASE("Late and foreign replies on a good connection are dropped without a new connection") {
  ModbusPlc plc;
  DialogBench bench(versioned_list(), plc.port(), "event-values=holding-registers:500");
  REQUIRE_FALSE(bench.dialog().open());
  plc.lie({.seed = 5, .per_thousand = 1000, .kinds = {Lie::merged, Lie::byte_by_byte, Lie::flooded}});
  for (std::uint32_t version = 1; version < 50; ++version) {
    plc.with([&](PlcMemory& memory) { set_version(memory, version); });
    const Fault fault = bench.read();
    INFO(fault.message);
    REQUIRE_FALSE(fault);
    CHECK(wrong_values(bench, version) == 0);
  }
}
