// Finds which events follow which operations, for symbols that names do not pair.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "learn/chance.hpp"
#include "learn/follow.hpp"
#include "learn/input.hpp"
#include "model/plant_model.hpp"

namespace symplant::learn {

using model::kNone;

/// An operation and the event that follows it.
struct Pair {
  std::uint32_t operation = kNone;
  std::uint32_t event = kNone;
  bool inverted = false;  ///< the event changes to on after the operation changes to off
  bool named = false;     ///< names pair the operation with another event
  Follows on;             ///< of the event's changes to on
  Follows off;            ///< of its changes to off, after the other change of the operation
  Chance chance;          ///< of its changes to on

  /// Whether the event also changes to off in the same time after the other change of the operation. If not, as with
  /// two operations for the two ends of a move, it is enough that it changes to on.
  bool follows_off() const {
    return off.changes >= kLeastChanges && off.hits >= hits_needed(off.changes) && off.hits >= hits_needed(off.effects);
  }
};

/// An event that follows several operations, and which of them drives it cannot be said.
struct Interlock {
  enum class Kind : std::uint8_t {
    together,   ///< the operations change together
    alternate,  ///< the event follows one operation at one time, another one at other times
  };
  std::uint32_t event = kNone;
  Kind kind = Kind::together;
  std::vector<std::uint32_t> operations;
};

struct FanOut {
  std::uint32_t operation = kNone;
  std::vector<std::uint32_t> events;
};

struct Pairs {
  std::size_t operations = 0;  ///< that names do not pair and that changed
  std::size_t events = 0;      ///< also
  Time length = 0;             ///< of the recordings, without gaps
  Time resolution = 0;
  std::uint64_t seed = 0;
  std::vector<Pair> pairs;            ///< by operation, then event
  std::vector<FanOut> fan_outs;       ///< operations that several events of `pairs` follow
  std::vector<Interlock> interlocks;  ///< by event
};

/// Proposes pairs: at least kLeastChanges changes, 95 % hits, a narrow spread of delays, and fewer hits in all trials
/// with shifted times. What is accounted for without a pair, as operator's panels are, is left out.
/// O(changes * log(changes) + operations * 12 * changes of events within kLongestDelay).
Pairs learn_pairs(const model::PlantModel& plant, const std::vector<Input>& inputs, std::uint64_t seed);

}  // namespace symplant::learn
