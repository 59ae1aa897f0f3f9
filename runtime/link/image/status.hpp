// The status of the plant, as a link carries it (docs/links.md).
#pragma once

#include <array>
#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/status_fields.hpp"

namespace symplant::link::image {

enum class PlantState : std::uint16_t { waiting = 0, run = 1, link_lost = 2, frozen = 3, stopping = 4 };

struct Status {
  PlantState state = PlantState::waiting;
  std::uint64_t cycles = 0;
  std::uint64_t live = 0;  ///< bit i: link i is live
  std::uint64_t lost_exchanges = 0;
  std::uint64_t overruns = 0;
  std::uint64_t map_hash = 0;
};

/// The state of the plant for one link: stopping has priority, then frozen, then the state of the link.
inline PlantState plant_state(exec::LinkState link, bool frozen, bool stopping) noexcept {
  if (stopping) return PlantState::stopping;
  if (frozen) return PlantState::frozen;
  if (link == exec::LinkState::waiting) return PlantState::waiting;
  return link == exec::LinkState::lost ? PlantState::link_lost : PlantState::run;
}

/// The numbers in the order of kStatusFields.
inline std::array<std::uint64_t, kStatusFields.size()> numbers_of(const Status& status) noexcept {
  constexpr std::uint64_t kLayout = 1;  // changes with the fields
  return {kLayout,         status.cycles,  static_cast<std::uint64_t>(status.state), status.live, status.lost_exchanges,
          status.overruns, status.map_hash};
}

}  // namespace symplant::link::image
