// Tables of N double solenoids, built by hand: the loads of the engine benchmarks, without the tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "symplant/plant/plant.hpp"

namespace symplant::bench {

/// A plant and the tables on which it runs. The loads derive from it: they fill the tables, then make the plant.
struct BenchPlant {
  std::vector<tables::TypeRow> types;
  std::vector<tables::UnitRow> units;
  std::vector<tables::TransitionTimes> times;
  tables::PlantTables tables{};
  std::vector<std::max_align_t> memory;
  std::unique_ptr<plant::Plant> plant;
  static constexpr std::uint64_t kInverted = 0;  ///< the bits of every word that are inverted

 protected:
  /// `bits` of each device in both planes. Tables other than types, units and times must be set before.
  void make(std::uint32_t bits) {
    tables.types = types;
    tables.units = units;
    tables.times = times;
    tables.operation_bits = tables.event_bits = (bits * static_cast<std::uint32_t>(units.size()) + 63) / 64 * 64;
    make_as_is();
  }

  /// All tables must be set before.
  void make_as_is() {
    memory.resize(plant::Plant::memory_size(tables) / sizeof(std::max_align_t) + 1);
    plant = std::make_unique<plant::Plant>(tables, std::as_writable_bytes(std::span(memory)));
  }
};

/// N devices of one type with two states; unit u travels for times[u % times.size()] nanoseconds.
struct TwoStatePlant : BenchPlant {
  TwoStatePlant(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    for (const tables::Time travel : travel_times) times.push_back({0, travel});
    const bool one = times.size() == 1;  // then it is in the type, as the tool lowers it
    types.push_back({2, 2, 2, tables::kNoState, tables::Actuation::latched, one ? kTransitions : kOwnTransitions,
                     kEnter, kLeave, kTargets, times});
    for (std::uint32_t d = 0; d < devices; ++d) {
      const auto entry = static_cast<std::uint32_t>(d % travel_times.size());
      units.push_back({0, 0, 0, 2 * d, 2 * d, entry});
    }
    make(kStride);
  }

  static constexpr std::uint32_t kStride = 2;  ///< bits of a device in each plane
  static constexpr std::uint64_t kStateEvents = ~std::uint64_t{0};
  static constexpr std::array<tables::Transition, 2> kTransitions{{{0, 1, 1}, {1, 0, 0}}};
  static constexpr std::array<tables::Transition, 2> kOwnTransitions{
      {{0, 1, 1, false, tables::kNoCondition, false, tables::kOfDevice},
       {1, 0, 0, false, tables::kNoCondition, false, tables::kOfDevice}}};
  static constexpr std::array<tables::EventMasks, 2> kEnter{{{1, 0}, {2, 0}}};
  static constexpr std::array<tables::EventMasks, 2> kLeave{{{0, 1}, {0, 2}}};
  static constexpr std::array<std::uint8_t, 2> kTargets{0, 1};
};

/// N devices of `kTypes` types in random order. All have two states; the types differ in their number of operations and
/// in the events that they switch in addition to those of the two states.
template <std::uint32_t kTypes>
struct ManyTypesPlant : BenchPlant {
  ManyTypesPlant(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    masks.reserve(4 * kTypes);
    times.push_back({0, travel_times.front()});
    for (std::uint32_t n = 0; n < kTypes; ++n) {
      const std::uint64_t first = 1 | std::uint64_t{n / 32 % 8} << 2;
      const std::uint64_t second = 2 | std::uint64_t{n / 4 % 8} << 5;
      masks.insert(masks.end(), {{first, 0}, {second, 0}, {0, first}, {0, second}});
      const std::span<const tables::EventMasks> of_type = std::span(masks).subspan(4 * n, 4);
      types.push_back({static_cast<std::uint8_t>(2 + n % 4), 8, 2, tables::kNoState, tables::Actuation::latched,
                       TwoStatePlant::kTransitions, of_type.first(2), of_type.last(2),
                       std::span(kTargets).first(2 + n % 4), times});
    }
    std::uint32_t random = 12345;
    for (std::uint32_t d = 0; d < devices; ++d) {
      random = random * 1664525 + 1013904223;
      units.push_back({(random >> 10 & 0xFFFF) % kTypes, 0, 0, kStride * d, kStride * d, 0});
    }
    make(kStride);
  }

  static constexpr std::uint32_t kStride = 8;
  static constexpr std::uint64_t kStateEvents = 0x0303'0303'0303'0303;
  static constexpr std::array<std::uint8_t, 5> kTargets{0, 1, tables::kNoState, tables::kNoState, tables::kNoState};

  std::vector<tables::EventMasks> masks;
};

/// TwoStatePlant with all costly features: each device leaves only if a distant device is not settled in its first
/// state or another one is, for 10 ms; one device in eight disables its neighbor while it is settled in its second
/// state.
struct RichPlant : BenchPlant {
  RichPlant(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    times.push_back({kAfter, travel_times.front()});
    types.push_back({2, 2, 2, tables::kNoState, tables::Actuation::latched, kTransitions, TwoStatePlant::kEnter,
                     TwoStatePlant::kLeave, TwoStatePlant::kTargets, times});
    for (std::uint32_t d = 0; d < devices; ++d) {
      units.push_back({0, 0, 1, 2 * d, 2 * d, 0});
      conditions.push_back({0b1101, d, 0, tables::ReaderKind::unit});
      conditioned.push_back({d, d});
      watches.push_back({d, (d + devices - kFar % devices) % devices, 0, 0});
      watches.push_back({d, (d + devices - kFarther % devices) % devices, 0, 1});
      if (d % 8 == 0 && d + 1 < devices) disables.push_back({d, d + 1, 1});
    }
    tables.conditions = conditions;
    tables.conditioned_units = conditioned;
    tables.unit_watches = watches;
    tables.disables = disables;
    make(kStride);
  }

  static constexpr std::uint32_t kStride = TwoStatePlant::kStride;
  static constexpr std::uint64_t kStateEvents = TwoStatePlant::kStateEvents;
  static constexpr tables::Time kAfter = 10 * tables::kMillisecond;
  static constexpr std::uint32_t kFar = 37;
  static constexpr std::uint32_t kFarther = 61;
  static constexpr std::array<tables::Transition, 2> kTransitions{
      {{0, 1, 1, false, 0, true}, {1, 0, 0, false, 0, true}}};

  std::vector<tables::ConditionRow> conditions;
  std::vector<tables::ConditionedUnit> conditioned;
  std::vector<tables::UnitWatch> watches;
  std::vector<tables::DisableRow> disables;
};

/// TwoStatePlant in which each device leaves only while a distant device is not moving in vain: a condition that always
/// holds. With `kWhile` its moves also stop while it does not hold.
template <bool kWhile>
struct GuardedPlant : BenchPlant {
  GuardedPlant(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    times.push_back({0, travel_times.front()});
    types.push_back({2, 2, 2, tables::kNoState, tables::Actuation::latched, kTransitions, TwoStatePlant::kEnter,
                     TwoStatePlant::kLeave, TwoStatePlant::kTargets, times});
    for (std::uint32_t d = 0; d < devices; ++d) {
      units.push_back({0, 0, 1, 2 * d, 2 * d, 0});
      conditions.push_back({0b11, d, 0, tables::ReaderKind::unit});
      conditioned.push_back({d, d});
      watches.push_back({d, (d + devices - 37 % devices) % devices, 0, 0});
    }
    tables.conditions = conditions;
    tables.conditioned_units = conditioned;
    tables.unit_watches = watches;
    make(kStride);
  }

  static constexpr std::uint32_t kStride = TwoStatePlant::kStride;
  static constexpr std::uint64_t kStateEvents = TwoStatePlant::kStateEvents;
  static constexpr std::uint16_t kDuring = kWhile ? 0 : tables::kNoCondition;
  static constexpr std::array<tables::Transition, 2> kTransitions{
      {{0, 1, 1, false, 0, false, 0, kDuring}, {1, 0, 0, false, 0, false, 0, kDuring}}};

  std::vector<tables::ConditionRow> conditions;
  std::vector<tables::ConditionedUnit> conditioned;
  std::vector<tables::UnitWatch> watches;
};

/// TwoStatePlant with symbols, all of them inverted or none; the controller of the load answers with inverted bits.
template <bool kAllInverted>
struct SymbolPlant : BenchPlant {
  SymbolPlant(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    times.push_back({0, travel_times.front()});
    types.push_back({2, 2, 2, tables::kNoState, tables::Actuation::latched, TwoStatePlant::kTransitions,
                     TwoStatePlant::kEnter, TwoStatePlant::kLeave, TwoStatePlant::kTargets, times});
    for (std::uint32_t d = 0; d < devices; ++d) {
      units.push_back({0, 0, 0, 2 * d, 2 * d, 0});
      for (const auto direction : {tables::Direction::operation, tables::Direction::event}) {
        const auto kind =
            tables::symbol_kind(tables::DataType::boolean, direction, tables::AddressForm::number, true, kAllInverted);
        for (std::uint32_t i = 0; i < 2; ++i) symbols.push_back({2 * d + i, d, 2 * d + i, 1, kind});
      }
    }
    tables.symbols = symbols;
    make(kStride);
  }

  static constexpr std::uint32_t kStride = TwoStatePlant::kStride;
  static constexpr std::uint64_t kStateEvents = TwoStatePlant::kStateEvents;
  static constexpr std::uint64_t kInverted = kAllInverted ? ~std::uint64_t{0} : 0;

  std::vector<tables::SymbolRow> symbols;
};

}  // namespace symplant::bench
