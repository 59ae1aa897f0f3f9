// What the devices of a plant do, as their operations and events show it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::observe {

using model::kNone;
using tables::Time;

/// A time that is not known. All others are >= 0.
inline constexpr Time kUnknown = -1;

/// A transition of a unit that its events showed. States and transitions are indexes in model::Unit.
struct Move {
  std::uint32_t unit = kNone;
  std::uint32_t from = kNone;        ///< kNone: the unit was in no known state before
  std::uint32_t to = kNone;          ///< kNone: left, and not yet arrived
  std::uint32_t transition = kNone;  ///< whose cause held; kNone: nothing that is known caused it, or a spring's return
  bool spring_return = false;        ///< caused by the end of the command
  Time since = kUnknown;    ///< when the unit came to `from`, or left the state before if no event shows `from`
  Time cause = kUnknown;    ///< when the cause began to hold with the unit in `from`
  Time left = kUnknown;     ///< kUnknown: no event shows it, since `from` has no event that is on
  Time arrived = kUnknown;  ///< kUnknown: no event shows it, since `to` has no event that is on
  Time stopped = 0;         ///< how long the model did not let it move meanwhile
  Time halted = 0;          ///< of `stopped`: how long a held device had no command when it arrived
  /// Its times say little: it was commanded back or without a command meanwhile, or the recording does not show for
  /// certain that it was at rest in `from`, that nothing else caused it, or whether it was stopped.
  bool turned = false;

  bool is_caused() const { return cause != kUnknown; }
};

/// What happened to a unit at one time.
struct Step {
  enum class Kind : std::uint8_t {
    caused,         ///< `move`: a cause began to hold; it has no times but `cause`
    canceled,       ///< `move`: that cause ended before its unit left the state
    left,           ///< `move`: the unit left the state; complete if no event can show the arrival in `to`
    arrived,        ///< `move` is complete; also from an unknown state, and back to the state that it left (`to` is
                    ///< `from`); after a contradiction it has arrived when that began
    contradiction,  ///< its events are on in a combination that no state has; `move.from` is its last state
    settled,        ///< after a contradiction its events are those of state `move.to` again; kNone: none is on
  };
  Kind kind = Kind::arrived;
  Move move;
};

/// What is known of a unit now.
struct View {
  std::uint32_t state = kNone;    ///< in which it is, or which it left; kNone: not known
  bool moving = false;            ///< it left `state`
  bool contradicts = false;       ///< its events are those of no state, and of more than one
  bool stopped = false;           ///< the model does not let it move now; `next.stopped` has the stops that ended
  Time since = kUnknown;          ///< when it came to the state, or left it
  Time stopped_since = kUnknown;  ///< kUnknown: it is not stopped
  Move next;                      ///< `cause` is known: the move whose cause holds, or which is going on
};

/// Follows the devices of a plant by the changes of their symbols. It knows the model's states, causes and conditions,
/// but predicts nothing: a unit is where its events say. A unit without events stays unknown, as does a condition of
/// what is not recorded. Not thread-safe.
class Observer {
 public:
  /// `recorded`: by index in PlantModel::symbols, whether changes of the symbol will be given. `resolution`: the
  /// interval of reading; a cause that ended up to two intervals ago is still one. The plant must outlive the observer.
  /// O(plant).
  Observer(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution);
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  ~Observer();

  /// Sets a symbol to a value from the time of the next close(): a BOOL as its bit, 0 or 1. O(1).
  void set(std::uint32_t symbol, double value);
  /// Ends a time: all changes since the last one happened at `time`, which must not decrease. The first one sets the
  /// state from which on units are followed. Returns what happened, valid until the next call. O(changes, and the units
  /// that depend on them).
  std::span<const Step> close(Time time);
  /// Forgets the states and causes of all units, as after a gap: what follows is as at the beginning. O(units).
  void forget();

  View view(std::uint32_t unit) const;
  /// The value of a symbol as set last. O(1).
  double value(std::uint32_t symbol) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace symplant::observe
