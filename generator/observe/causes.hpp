// What makes a unit leave its state.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/truth.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::observe {

/// A transition whose cause holds.
struct Cause {
  std::uint32_t to = model::kNone;          ///< kNone: there is no cause
  std::uint32_t transition = model::kNone;  ///< kNone: a spring's return
  tables::Time since = -1;                  ///< when it began to hold; < 0: not known, or not known whether it holds

  bool is_spring_return() const { return to != model::kNone && transition == model::kNone; }
  bool is_certain() const { return to != model::kNone && since >= 0; }
  friend bool operator==(const Cause&, const Cause&) = default;
};

/// The levels of a unit's operations, by index in Unit::operations.
struct Levels {
  std::uint64_t on = 0;
  std::uint64_t known = 0;
};

/// The causes of one unit in its present state (docs/model.md, "Transitions").
class Causes {
 public:
  /// Enters a state: causes that hold begin at the next update; `time` < 0: when they began is not known.
  void enter(const model::Unit& unit, std::uint32_t state, tables::Time time);
  /// Brings the causes up to date. O(transitions and conditions of the unit).
  /// `may_begin`: the unit is not disabled. `shown`: an event shows when it leaves its state.
  void update(const model::Unit& unit, Levels levels, const Known& known, tables::Time time, bool may_begin,
              bool shown);

  /// What the model would do next; nothing if nothing is caused, if it is not certain, or if commands conflict.
  const Cause& pending() const { return pending_; }
  /// The best known cause of a transition to `to`, or of any if that is kNone. One that ended counts up to `grace`
  /// after its end.
  Cause of(const model::Unit& unit, std::uint32_t to, tables::Time now, tables::Time grace) const;
  /// Disarms what leaving by this cause disarms in a latched unit.
  void leave(const model::Unit& unit, const Cause& cause);
  /// What the unit did is not certain, so that operations that are on may be disarmed: not known until they were off.
  void doubt(const model::Unit& unit);
  /// Whether an operation that is on commands the move from `from` to `to`; the opposite one.
  bool commands(const model::Unit& unit, std::uint32_t from, std::uint32_t to) const;
  /// Whether another cause may have made the unit leave for the same state, for any if `to_any`, or for one from which
  /// it can go on to the same state within `resolution`. `prompt`: only causes that make it leave at once count.
  bool has_rival(const model::Unit& unit, const Cause& cause, bool to_any, bool prompt, tables::Time resolution) const;
  /// Whether the unit may have left its state for one of those for which `is_dark` holds.
  template <class IsDark>
  bool may_have_left_for(const model::Unit& unit, IsDark&& is_dark) const {
    for (std::size_t i = 0; i < unit.transitions.size(); ++i) {
      if (unit.transitions[i].from == state_ && since_[i] != tables::kNever && is_dark(unit.transitions[i].to))
        return true;
    }
    return quiet_ != tables::kNever && is_dark(unit.rest);
  }
  /// The state to which a cause leads from `state` within `resolution` as long as all stays as it is, so that no event
  /// may show `state`; kNone: it stays there. O(transitions and conditions of the unit).
  std::uint32_t passes_to(const model::Unit& unit, std::uint32_t state, const Known& known,
                          tables::Time resolution) const;

 private:
  /// Whether the model has begun the pending move, and completes it also if its cause ends.
  bool is_committed(const model::Unit& unit, tables::Time time, bool shown) const;
  bool leads_to(const model::Unit& unit, std::uint32_t operation, std::uint32_t state) const;
  struct Commanded {
    Cause cause;
    tables::Time ready = -1;  ///< when it can make the unit leave; kNever: nothing can
    bool conflicts = false;   ///< with another command, or one for the present state
  };
  Cause automatic(const model::Unit& unit) const;
  Commanded commanded(const model::Unit& unit, tables::Time time) const;
  Cause choose(const model::Unit& unit, tables::Time time);
  void update_quiet(const model::Unit& unit, tables::Time time);

  std::vector<tables::Time> since_;  ///< by transition: kHoldsNot, < 0: not known, else when it began
  std::uint64_t on_ = 0;             ///< operations that are on, and armed
  std::uint64_t level_ = 0;
  std::uint64_t known_ = 0;
  std::uint64_t disarmed_ = 0;
  std::uint64_t doubtful_ = 0;  ///< may be disarmed
  tables::Time entered_ = -1;
  tables::Time quiet_ = tables::kNever;  ///< since when nothing is wanted; kNever: something is; < 0: not known
  std::uint32_t state_ = model::kNone;
  bool conflicts_ = false;        ///< commands conflict
  tables::Time conflicted_ = -1;  ///< until when they did last
  bool fresh_ = true;             ///< no update since enter()
  Cause pending_;
  Cause ended_;
  tables::Time ended_at_ = -1;
};

}  // namespace symplant::observe
