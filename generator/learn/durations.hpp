// Collects the times of moves from recordings.
#pragma once

#include <cstdint>
#include <vector>

#include "learn/input.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// A move from one state to another with its times, as in observe::Move.
struct TimedMove {
  Time cause = 0;
  Time left = observe::kUnknown;
  Time arrived = observe::kUnknown;
  Time stopped = 0;  ///< between cause and arrival
  std::uint32_t input = 0;
  /// From a state without an event: for how long the device may have been there when the cause began; else kUnknown.
  Time rest = observe::kUnknown;

  bool shows_leaving() const { return left != observe::kUnknown; }
  bool shows_arrival() const { return arrived != observe::kUnknown; }
};

/// All moves of a transition, and of those with the same states and operation under other conditions, in the order of
/// recordings and times.
struct TransitionMoves {
  std::uint32_t unit = kNone;
  std::uint32_t from = kNone;
  std::uint32_t to = kNone;
  std::uint32_t transition = kNone;  ///< kNone: a spring's return
  std::vector<TimedMove> moves;
};

struct UnitMoves {
  std::uint32_t unit = kNone;
  std::vector<TransitionMoves> transitions;  ///< by their states
  std::vector<Sample> overruns;  ///< how long the command of a move stayed on after arrival; of `held` units
};

/// When a unit came to a state, or left one.
struct StateChange {
  Time time = 0;
  std::uint32_t state = kNone;  ///< kNone: moving
};

/// What recordings show of all units.
struct Moves {
  std::vector<UnitMoves> units;  ///< by index of units; only those that moved
  /// By input, then by unit of the plant: its states, by time.
  std::vector<std::vector<std::vector<StateChange>>> states;
  std::vector<std::vector<bool>> taken;  ///< by unit of the plant, by transition: a move that it caused was seen
  std::vector<bool> moved;               ///< by unit of the plant
  std::vector<UnusedMoves> unused_of;    ///< by unit of the plant, without reasons
  std::size_t count = 0;                 ///< moves with the times of a transition
  std::size_t unused = 0;                ///< those that turned round, or without a cause
};

/// The moves of one input, as observe::moves_of() returns them.
class MoveCollector {
 public:
  explicit MoveCollector(const model::PlantModel& plant);
  /// Adds the moves of the next input. O(moves + changes of operations of `held` units).
  void add(const Input& input, const std::vector<observe::Move>& moves);
  Moves finish();

 private:
  void add_move(const observe::Move& move, std::uint32_t input);
  void add_overruns(const Input& input, const std::vector<observe::Move>& moves, std::uint32_t number);

  const model::PlantModel& plant_;
  Moves moves_;
  std::vector<UnitMoves> by_unit_;
  std::uint32_t inputs_ = 0;
};

/// O(changes of all inputs).
Moves moves_of(const model::PlantModel& plant, const std::vector<Input>& inputs);

}  // namespace symplant::learn
