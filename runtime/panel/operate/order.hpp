// What the panel asks of the thread that runs the plant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"

namespace symplant::panel {

/// One order. What it points to is prepared by the panel and lives until the note about the order is drained.
struct Order {
  enum class Kind : std::uint8_t {
    act,          ///< `steps`, whose times do not count
    run,          ///< lets plant time run
    freeze,       ///< stops it
    step_cycle,   ///< runs one cycle, then freezes
    step_change,  ///< runs until a cycle with a change, then freezes
    reset,        ///< to time 0; a scenario begins again
    copy,         ///< copies Plant::save() to `block`, and the state of the scenario to `played`
    restore,      ///< the state of `block`, and of the scenario in `played`; without one the scenario ends
    play,         ///< plays `player` from now on; null: no scenario
  };
  Kind kind = Kind::run;
  std::uint32_t id = 0;
  std::span<const scenario::Step> steps = {};
  std::span<std::byte> block = {};
  scenario::Player::State* played = nullptr;
  scenario::Player* player = nullptr;
};

/// The `of` of the note after an order was carried out: its value is the order's id, which is below kNoRoom, the bits
/// of why it failed, and from scenario::kTurnBits on its turn (Recorder::turn()). The records of the instant in which
/// it takes effect follow.
inline constexpr std::uint32_t kOrderNote = 0xFFFF'FFFB;
inline constexpr std::uint64_t kNoRoom = std::uint64_t{1} << 30;  ///< for a part
inline constexpr std::uint64_t kNoPart = std::uint64_t{1} << 31;  ///< to take
inline constexpr std::uint64_t kNotDone = std::uint64_t{1}
                                          << 32;  ///< too many malfunctions, or a state that does not fit
inline constexpr std::uint64_t kFailed = kNoRoom | kNoPart | kNotDone;
static_assert(kFailed < std::uint64_t{1} << scenario::kTurnBits);

/// The `of` of the note that the scenario that is played is over.
inline constexpr std::uint32_t kOverNote = 0xFFFF'FFFA;

}  // namespace symplant::panel
