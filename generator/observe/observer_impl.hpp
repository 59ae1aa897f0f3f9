// How an observer follows the units of a plant.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "observe/causes.hpp"
#include "observe/dependents.hpp"
#include "observe/observer.hpp"
#include "observe/positions.hpp"
#include "observe/truth.hpp"

namespace symplant::observe {

class Observer::Impl {
 public:
  Impl(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution);

  void set(std::uint32_t symbol, double value);

  std::span<const Step> close(Time time);

  void forget_all() {
    forget();
    begun_at_ = kUnknown;
  }

  View view(std::uint32_t unit) const;

  double value(std::uint32_t symbol) const { return values_[symbol]; }

 private:
  struct Followed {
    Positions positions;
    Causes causes{};
    std::uint32_t state = kNone;
    bool moving = false;
    bool contradicts = false;
    bool queued = false;
    bool unsure = false;              ///< it may have gone on from a state without an event to another one
    Time rests_since = kUnknown;      ///< when it was left alone to come to its state; kUnknown: before the recording
    bool held_back = false;           ///< it may have been disabled since then
    std::uint32_t passed_to = kNone;  ///< to where it may have gone on from the state to which it moves
    std::uint32_t came_from = kNone;  ///< the state before, if no event shows this one
    bool came_by_command = false;
    bool at_once = false;     ///< it came to its state without travel
    Cause set_back{};         ///< ended while it may have begun to move: the next move is not from rest
    int steps = 0;            ///< at the present time
    std::uint64_t visit = 0;  ///< the number of that time
    Time since = kUnknown;
    Time contradicts_since = kUnknown;
    Time stopped_since = kUnknown;  ///< kUnknown: it is not stopped
    Move next{};                    ///< what is caused, or going on
  };

  void forget();

  void queue(std::uint32_t unit);

  bool depends_on_queued(std::uint32_t unit) const;

  void queue_dependents(std::uint32_t unit);

  /// The level of an event of the unit `own_` in its state, as a bit; nothing if the state does not say, or if it is an
  /// operation.
  std::optional<double> own_level(std::uint32_t symbol) const;

  /// Bits of symbols as levels, by index in `symbols`.
  Levels levels(const std::vector<std::uint32_t>& symbols) const;

  void begin();

  /// Reports what is caused now, and what no longer is.
  void update_causes(std::uint32_t u);

  Move move_of(std::uint32_t u, const Cause& cause) const;

  void add(Step::Kind kind, const Move& move) { steps_.push_back({kind, move}); }

  /// Whether a unit in a state without an event has had time enough to come to it.
  bool is_surely_settled(std::uint32_t u) const;

  static Time longest_travel(const model::Unit& unit, std::uint32_t to);

  /// The transition whose time and `while` a move has; kNone: that of no transition.
  static std::uint32_t timed_by(const model::Unit& unit, const Move& move);

  /// Whether it is not known if the unit is disabled or stopped.
  bool may_be_stopped(std::uint32_t u) const;

  std::uint32_t passes_to(std::uint32_t u, std::uint32_t state);

  /// Whether the unit may have come to the state to which it moves, left it at once, and come back, while no event
  /// showed it.
  bool may_have_passed(std::uint32_t u);

  bool is_disabled(std::uint32_t u) const;

  /// Whether the model lets the unit not go on with its move now.
  bool is_stopped(std::uint32_t u) const;

  /// Whether a stopped unit would go on with its move if its command were on.
  bool lacks_command_only(std::uint32_t u) const;

  /// Whether commands keep the unit from reaching the state without an event to which it went.
  bool is_halted_unseen(std::uint32_t u) const;

  /// Notes stops and turns of a move that goes on, also of one whose leaving no event shows.
  void follow_move(std::uint32_t u);

  /// Brings one unit up to date; false if it changed its state without a cause and may wait for one.
  bool follow(std::uint32_t u, bool last_resort);

  Cause cause_of(std::uint32_t u, std::uint32_t to) const;

  void leave(std::uint32_t u);

  /// Whether the unit can only have gone to a state without an event.
  bool dark_is_next(std::uint32_t u) const { return units_[u].positions.dark_state() != kNone; }

  /// Makes `next` the move that starts now by this cause.
  void begin_move(std::uint32_t u, const Cause& cause);

  /// Whether something else may have caused the move that begins now.
  bool is_ambiguous(std::uint32_t u, const Cause& cause) const;

  /// Whether a unit in a state without an event may still have been moving there when its next move was caused.
  bool may_not_have_rested(std::uint32_t u, Time arrived) const;

  void arrive(std::uint32_t u, std::uint32_t state, Time time);

  /// A move ended elsewhere than it was caused to.
  void take_other_end(std::uint32_t u, std::uint32_t state);

  void settle(std::uint32_t u, std::uint32_t state, Time time);

  /// It may be in one of several states.
  void lose(std::uint32_t u);

  void contradict(std::uint32_t u);

  void clear_contradiction(std::uint32_t u);

  void end_contradiction(std::uint32_t u, std::uint32_t state);

  const model::PlantModel& plant_;
  const Time grace_;
  std::vector<double> values_;
  std::vector<bool> known_;
  Dependents dependents_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> disabled_by_;  ///< by unit: unit, state
  std::vector<Followed> units_;
  Known view_;
  std::uint32_t own_ = kNone;  ///< the unit whose conditions are examined as if it were in own_state_
  std::uint32_t own_state_ = kNone;
  std::vector<std::uint32_t> queue_;
  std::vector<Step> steps_;
  Time now_ = 0;
  std::uint64_t visit_ = 0;
  bool begun_ = false;
  Time begun_at_ = kUnknown;
};

}  // namespace symplant::observe
