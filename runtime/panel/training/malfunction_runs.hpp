// Each malfunction of a run from its start to its end: its first effect, and the first act of each trainee after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/malfunction_marks.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The time of what has not happened so far.
inline constexpr tables::Time kNotYet = -1;

/// A malfunction, from a start to its end. Times are plant times in ns.
struct MalfunctionRun {
  struct Reaction {
    std::uint32_t trainee = 0;
    tables::Time at = 0;  ///< of the first act after the first effect
  };

  std::uint64_t n = 0;            ///< counts the runs from 0
  std::uint32_t malfunction = 0;  ///< as tables::MalfunctionNumbers numbers them
  tables::Time start = 0;
  tables::Time effect = kNotYet;  ///< the first effect
  tables::Time end = kNotYet;
  std::vector<Reaction> reactions;  ///< at most one of each trainee, in their order
};

/// Follows the records of a run. The first effect of a malfunction, at its start or later, until its end, is
/// - of `force`, `flicker` and `distort`: the first change of one of their symbols. An event that a device drives also
///   shows its effect when the device moves or comes into a state, and would switch the event to another value than it
///   has: a sensor that is stuck off while it is off.
/// - of `stuck` and `slower`: the first time that one of the devices changes its state, moves, or has a command to a
///   state other than its own (a spring without a command: to its state of rest); of a track: that the motion of its
///   parts changes;
/// - of `lose` and `set`: the start.
/// Of several effects the earliest counts. What changes in the instant of the end is no effect.
///
/// Used by one thread at a time. Keeps the last kMostRuns. apply() is O(1) for records that concern no malfunction
/// without an effect so far, else O(active malfunctions * log(what they act on)).
class MalfunctionRuns {
 public:
  static constexpr std::size_t kMostRuns = 200;

  /// Both must outlive it.
  MalfunctionRuns(const trace::PlantNames& names, const trace::History& history);

  /// To be called after History::apply(), not for notes.
  void apply(const trace::Record& record);
  /// A trainee acted on the plant at `time`: this is a reaction to each active malfunction with an effect so far.
  /// To be called before the records of the instant in which the act takes effect, so that an effect of the act itself
  /// is not one to which it reacts. O(runs).
  void acted(std::uint32_t trainee, tables::Time time);
  /// The plant was set back to the time `after` (-1: to its start), and History::load() was called: forgets what was
  /// later. O(plant).
  void set_back(tables::Time after);

  /// The last ones, the oldest first.
  const std::deque<MalfunctionRun>& runs() const { return runs_; }
  /// Grows with each change.
  std::uint64_t version() const { return version_; }

 private:
  /// A run that is active and had no effect so far.
  struct Waiting {
    std::uint64_t n = 0;
    std::vector<std::uint32_t> symbols;  ///< ascending, as the following
    std::vector<std::uint32_t> driven;   ///< devices that drive one of `symbols`
    std::vector<std::uint32_t> units;
    std::vector<std::uint32_t> tracks;
    bool at_once = false;  ///< it has an effect at its start, whatever the plant does
  };

  Waiting waiting_for(const MalfunctionRun& run) const;
  void start(std::uint32_t malfunction, tables::Time time);
  void end(std::uint32_t malfunction, tables::Time time);
  void forget_oldest();
  MalfunctionRun* run_of(std::uint64_t n);
  void watch(Waiting waiting);
  void count(const Waiting& waiting, bool more);
  template <class IsEffect>
  void look(tables::Time time, IsEffect is_effect);
  void unit_changed(const trace::Record& record);
  void instant_ended();
  bool acts_now(const Waiting& waiting) const;
  bool shows_in_instant(const Waiting& waiting) const;
  bool is_commanded_elsewhere(std::uint32_t unit) const;
  bool is_masked(const Waiting& waiting, std::uint32_t unit, const tables::EventMasks& switched) const;

  const trace::PlantNames& names_;
  const trace::History& history_;
  std::deque<MalfunctionRun> runs_;
  std::uint64_t next_ = 0;
  std::uint64_t version_ = 0;
  std::vector<Waiting> waiting_;
  std::vector<std::uint32_t> watched_symbols_;  ///< how many of `waiting_` look at each
  std::vector<std::uint32_t> watched_units_;
  std::vector<std::uint32_t> watched_tracks_;
  std::vector<std::uint32_t> units_;  ///< pack_unit() before the record that is applied
  // Of the instant that is being applied: the records of malfunctions come after those of symbols and units.
  std::vector<std::uint32_t> changed_symbols_;
  std::vector<std::uint32_t> changed_units_;  ///< whose state changed
  std::vector<std::uint32_t> changed_tracks_;
  std::vector<std::uint64_t> affected_;  ///< runs whose first effect is in it
};

}  // namespace symplant::panel
