// What the panel asks of the thread that runs the plant.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"

namespace symplant::panel {

/// The clock of acts: milliseconds since an arbitrary time; it never goes back. Also for the thread of the plant.
inline std::int64_t act_clock() noexcept {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}
inline constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

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
  std::int64_t until = kNoLimit;  ///< by act_clock(): after it, the order is not carried out
};

/// The `of` of the note after an order. Its value is the sum of the order's id, which is below kLeastOutcome, of
/// kTooLate or kDoesNotFit if it was not carried out, and from scenario::kTurnBits on of its turn (Recorder::turn()).
/// The records of the instant in which it takes effect follow. Before it there is a scenario::kRefusedNote for each
/// part of its steps that was refused.
inline constexpr std::uint32_t kOrderNote = 0xFFFF'FFFB;
inline constexpr std::uint64_t kLeastOutcome = std::uint64_t{1} << 31;
inline constexpr std::uint64_t kTooLate = kLeastOutcome;          ///< its time was over
inline constexpr std::uint64_t kDoesNotFit = kLeastOutcome << 1;  ///< the state is one of another plant
static_assert(kDoesNotFit < std::uint64_t{1} << scenario::kTurnBits);

/// The `of` of the note that the scenario that is played is over.
inline constexpr std::uint32_t kOverNote = 0xFFFF'FFFA;

}  // namespace symplant::panel
