// The symplant server as the expectation table requires it: a plant of symbols that no device drives, on a Modbus link.
#include <chrono>
#include <iostream>
#include <thread>

#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/version.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;

namespace {

constexpr std::uint32_t kBits = 2016;
constexpr std::uint32_t kRegisters = 160;
constexpr tables::Time kCycle = 10 * tables::kMillisecond;  // the default of a run

test::SymbolList symbols() {
  test::SymbolList list;
  for (std::uint32_t i = 0; i < kBits; ++i) {
    list.add("C" + std::to_string(i), test::SymbolList::kOut, i);
    list.add("D" + std::to_string(i), test::SymbolList::kIn, i);
  }
  for (std::uint32_t i = 0; i < kRegisters; ++i) {
    list.add("H" + std::to_string(i), test::SymbolList::kOut, i, tables::DataType::word);
    const std::uint32_t row = list.add("I" + std::to_string(i), test::SymbolList::kIn, i, tables::DataType::word);
    list.start_at(row, 0xF000 + i);
  }
  return list;
}

}  // namespace

int main() {
  const test::SymbolList list = symbols();
  const tables::PlantTables tables = list.tables();
  test::OwnedPlant plant(tables);
  // Rows go C0, D0, C1, D1 ...
  for (std::uint32_t i = 0; i < kBits; ++i) plant->set_input(2 * i + 1, i % 5 < 2 ? 1 : 0);
  plant->advance_to(0);
  // Without a status block the tables end with the symbols, as the conformance table expects.
  const link::LinkSettings settings{.status_block = link::kNowhere};
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables, settings);
  link->write_events(*plant, {});
  plant->forget_changed_events();
  std::cout << test::port_of(*link);
  for (const std::uint32_t size : link::modbus::make_io_map(tables, 0, settings).sizes) std::cout << ' ' << size;
  std::cout << " symplant " << tables::version() << std::endl;
  for (tables::Time time = kCycle;; time += kCycle) {
    link->read_operations(*plant, time);
    plant->advance_to(time);
    link->write_events(*plant, {});
    plant->forget_changed_events();
    std::this_thread::sleep_for(std::chrono::nanoseconds(kCycle));
  }
}
