// The paper's cell as hand-written tables: an AGV and a machine, two states each, every travel 1 s.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "symplant/plant/plant.hpp"

namespace symplant::test {

/// A plant with separate memory.
class OwnedPlant {
 public:
  explicit OwnedPlant(const tables::PlantTables& tables)
      : memory_(plant::Plant::memory_size(tables) / sizeof(std::max_align_t) + 1),
        plant_(tables, std::as_writable_bytes(std::span(memory_))) {}

  plant::Plant& operator*() noexcept { return plant_; }
  plant::Plant* operator->() noexcept { return &plant_; }

 private:
  std::vector<std::max_align_t> memory_;
  plant::Plant plant_;
};

namespace cell {

/// Bits in the planes and rows in the symbol list.
enum Operation : std::uint32_t { kAgvToP2, kAgvToP1, kMachineToIdle1, kMachineToRun2 };
enum Event : std::uint32_t { kAgvAtP1, kAgvAtP2, kMachineIdle1, kMachineRun2 };

inline constexpr std::array<tables::EventMasks, 2> kEnter = {{{1, 0}, {2, 0}}};
inline constexpr std::array<tables::EventMasks, 2> kLeave = {{{0, 1}, {0, 2}}};
inline constexpr std::array kAgvTransitions = {tables::Transition{0, 1, 0}, tables::Transition{1, 0, 1}};
inline constexpr std::array<std::uint8_t, 2> kAgvTargets = {1, 0};
inline constexpr std::array kMachineTransitions = {tables::Transition{0, 1, 1}, tables::Transition{1, 0, 0}};
inline constexpr std::array<std::uint8_t, 2> kMachineTargets = {0, 1};
inline constexpr std::array kTimes = {tables::TransitionTimes{0, tables::kSecond}};
inline constexpr std::array kTypes = {
    tables::TypeRow{2, 2, 2, tables::kNoState, tables::Actuation::latched, kAgvTransitions, kEnter, kLeave, kAgvTargets,
                    kTimes},
    tables::TypeRow{2, 2, 2, tables::kNoState, tables::Actuation::latched, kMachineTransitions, kEnter, kLeave,
                    kMachineTargets, kTimes},
};
inline constexpr std::array kUnits = {tables::UnitRow{0, 0, 0, 0, 0, 0}, tables::UnitRow{1, 0, 0, 2, 2, 0}};

constexpr tables::SymbolRow symbol(std::uint32_t index, std::uint32_t unit, tables::Direction direction,
                                   std::uint32_t row) {
  return {.index = index,
          .unit = unit,
          .number = index + 1,  // X0001 and Y0001 are the first
          .row = row,
          .kind = tables::symbol_kind(tables::DataType::boolean, direction, tables::AddressForm::number, true)};
}
inline constexpr auto kIn = tables::Direction::event;
inline constexpr auto kOut = tables::Direction::operation;
inline constexpr std::array kSymbols = {symbol(0, 0, kIn, 2),  symbol(1, 0, kIn, 3), symbol(0, 0, kOut, 4),
                                        symbol(1, 0, kOut, 5), symbol(2, 1, kIn, 6), symbol(3, 1, kIn, 7),
                                        symbol(2, 1, kOut, 8), symbol(3, 1, kOut, 9)};

template <std::size_t N>
constexpr std::string_view blob(const char (&text)[N]) {
  return {text, N};
}

}  // namespace cell

inline tables::PlantTables cell_tables() {
  tables::PlantTables tables{};
  tables.name = "cell";
  tables.types = cell::kTypes;
  tables.units = cell::kUnits;
  tables.symbols = cell::kSymbols;
  tables.operation_bits = 64;
  tables.event_bits = 64;
  tables.unit_names = cell::blob("EXLINE_MB_AGV\0EXLINE_MB_MC");
  tables.state_names = cell::blob("P1\0P2\0IDLE1\0RUN2");
  tables.symbol_names = cell::blob(
      "EXLINE_MB_AGV_I_P1\0X0001\0EXLINE_MB_AGV_I_P2\0X0002\0"
      "EXLINE_MB_AGV_O_P2\0Y0001\0EXLINE_MB_AGV_O_P1\0Y0002\0"
      "EXLINE_MB_MC_I_IDLE1\0X0003\0EXLINE_MB_MC_I_RUN2\0X0004\0"
      "EXLINE_MB_MC_O_IDLE1\0Y0003\0EXLINE_MB_MC_O_RUN2\0Y0004");
  tables.list_names = {"cell.csv", 9};
  return tables;
}

}  // namespace symplant::test
