// When units must be looked at although nothing happened.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::watch {

struct Timer {
  enum class Kind : std::uint8_t {
    missing,        ///< the move that is expected
    contradiction,  ///< events of several states
    dark,           ///< no event of a state
    unexpected,     ///< a change without a cause: what is read next may still be its cause
    failed,         ///< a command that ended without effect, which may still be read
  };
  tables::Time due = 0;
  std::uint32_t unit = 0;
  Kind kind = Kind::missing;
  std::uint32_t generation = 0;
};

/// The earliest first. A unit has one timer of `unexpected`, one of `failed`, and one of the other kinds. Timers that
/// were replaced stay in the queue until they are due: setting one costs no search.
class Timers {
 public:
  explicit Timers(std::size_t units) : lanes_(units) {}

  /// Replaces the timer of the unit. O(log timers).
  void set(std::uint32_t unit, Timer::Kind kind, tables::Time due) {
    Lane& lane = lane_of(unit, kind);
    lane.is_set = true;
    queue_.push({due, unit, kind, ++lane.generation});
  }
  /// Also one of another kind that this kind would replace. O(1).
  void cancel(std::uint32_t unit, Timer::Kind kind) {
    lane_of(unit, kind) = {lane_of(unit, kind).generation + 1, false};
  }
  bool is_set(std::uint32_t unit, Timer::Kind kind) { return lane_of(unit, kind).is_set; }
  /// O(units).
  void cancel_all() {
    queue_ = {};
    for (auto& lanes : lanes_) lanes = {};
  }

  /// Calls `fire` for each that is due before `now`, by due time, also for those that it sets.
  template <class Fire>
  void run(tables::Time now, const Fire& fire) {
    while (!queue_.empty() && queue_.top().due < now) {
      const Timer timer = queue_.top();
      queue_.pop();
      if (timer.generation != lane_of(timer.unit, timer.kind).generation) continue;
      cancel(timer.unit, timer.kind);
      fire(timer);
    }
  }

 private:
  struct Lane {
    std::uint32_t generation = 0;
    bool is_set = false;
  };
  struct Later {
    bool operator()(const Timer& a, const Timer& b) const { return a.due != b.due ? a.due > b.due : a.unit > b.unit; }
  };
  Lane& lane_of(std::uint32_t unit, Timer::Kind kind) {
    return lanes_[unit][kind == Timer::Kind::unexpected ? 1 : kind == Timer::Kind::failed ? 2 : 0];
  }

  std::priority_queue<Timer, std::vector<Timer>, Later> queue_;
  std::vector<std::array<Lane, 3>> lanes_;  ///< by unit
};

}  // namespace symplant::watch
