// Tables of N double solenoids, built by hand: the engine's load, without the tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "symplant/core/plant.hpp"

namespace symplant::bench {

/// N devices of one type with two states; unit u travels times[u % times.size()] nanoseconds.
struct TwoStatePlant {
  TwoStatePlant(std::uint32_t devices, const std::vector<core::Time>& travel_times) {
    types.push_back({2, 2, 2, core::kNoState, core::Actuation::latched, kTransitions, kMasks, kMasks, kTargets});
    for (const core::Time travel : travel_times) {
      times.push_back({0, travel});
      times.push_back({0, travel});
      times.push_back({0, travel});
    }
    for (std::uint32_t d = 0; d < devices; ++d) {
      const auto entry = static_cast<std::uint32_t>(3 * (d % travel_times.size()));
      units.push_back({0, 2 * d, 2 * d, entry, 0});
    }
    tables.types = types;
    tables.units = units;
    tables.times = times;
    tables.operation_bits = tables.event_bits = (2 * devices + 63) / 64 * 64;
    memory.resize(core::Plant::memory_size(tables) / sizeof(std::max_align_t) + 1);
    plant = std::make_unique<core::Plant>(tables, std::as_writable_bytes(std::span(memory)));
  }

  static constexpr std::array<core::Transition, 2> kTransitions{{{0, 1, 1}, {1, 0, 0}}};
  static constexpr std::array<std::uint64_t, 2> kMasks{1, 2};
  static constexpr std::array<std::uint8_t, 2> kTargets{0, 1};

  std::vector<core::TypeRow> types;
  std::vector<core::UnitRow> units;
  std::vector<core::TransitionTimes> times;
  core::PlantTables tables{};
  std::vector<std::max_align_t> memory;
  std::unique_ptr<core::Plant> plant;
};

}  // namespace symplant::bench
