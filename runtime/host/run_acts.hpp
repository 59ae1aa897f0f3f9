// The acts of a run that are neither steps of a scenario nor orders of the panel, as values of trace::kActNote.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// An act for a trace: as JSON, and what did it: `hand` or `scenario`.
struct ActText {
  std::string json;
  std::string_view by;
};

/// The start or end of a malfunction, by its number. Steps of a scenario have smaller values.
constexpr std::uint64_t run_act(std::uint32_t malfunction, bool starts, bool by_hand) noexcept {
  return std::uint64_t{1} << 63 | std::uint64_t{starts} << 62 | std::uint64_t{by_hand} << 61 | malfunction;
}

constexpr bool is_run_act(std::uint64_t act) noexcept { return act >> 63 != 0; }

/// The text of an act of run_act().
ActText text_of_run_act(std::uint64_t act, const trace::PlantNames& names);

}  // namespace symplant::host
