// What was learned of a plant from recordings, as values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "description/duration.hpp"
#include "learn/pairs.hpp"
#include "model/plant_model.hpp"

namespace symplant::learn {

/// The version of the JSON form.
inline constexpr int kJsonVersion = 1;

/// A recording that was learned from.
struct Source {
  std::string name;
  Time length = 0;
  Time resolution = 0;
};

/// A time that a recording shows.
struct Sample {
  Time duration = 0;
  Time at = 0;              ///< when its cause began
  std::uint32_t input = 0;  ///< index in Learned::sources
  std::uint32_t unit = kNone;
};

/// Durations in a row, with no wide gap between neighbors: indexes of the sorted ones, [begin, end).
struct Cluster {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

/// Sorted durations, by groups.
struct Clusters {
  std::vector<Cluster> kept;          ///< by duration; at least one, unless there are no samples
  std::vector<std::size_t> outliers;  ///< indexes of the others, ascending
};

/// All figures are rounded to what the resolution of the samples allows.
struct Statistics {
  std::size_t count = 0;
  Time min = 0;
  Time median = 0;
  Time p95 = 0;
  Time max = 0;
};

/// What two groups of durations have to do with: the state of another device when the move was caused, or the kind of
/// the last part that had arrived at a location.
struct Explanation {
  struct Value {
    std::string name;       ///< of a state, or of a kind of parts
    std::size_t group = 0;  ///< index in Clusters::kept
  };
  std::uint32_t unit = kNone;  ///< kNone: parts at `location`
  std::string location;
  std::vector<Value> values;  ///< those seen, each with the group of most of its moves
  std::size_t right = 0;      ///< the moves that it explains
  std::size_t moves = 0;      ///< of both groups
  std::size_t others = 0;     ///< how many other devices and locations explain as many moves
};

/// A time of a device.
struct LearnedTime {
  std::vector<Sample> samples;  ///< by duration
  Clusters clusters;
  Time resolution = 0;    ///< of the coarsest recording with a sample
  Statistics statistics;  ///< without outliers
  description::Duration proposed;
  std::optional<Explanation> explanation;  ///< of two groups

  bool is_constant() const { return proposed.kind == description::Duration::Kind::fixed; }
};

/// The times of a transition. A reset makes a time 0: reality does not show it, and plant.json gives one.
struct LearnedTransition {
  std::uint32_t from = kNone;
  std::uint32_t to = kNone;
  std::uint32_t transition = kNone;  ///< kNone: a spring's return
  std::optional<LearnedTime> after;
  std::optional<LearnedTime> takes;
  bool resets_after = false;
  bool resets_takes = false;
};

struct LearnedDevice {
  std::uint32_t unit = kNone;
  std::vector<LearnedTransition> transitions;  ///< by their states
  std::optional<LearnedTime> overrun;
};

/// A device, or several under one pattern that agree in all that was learned of them.
struct LearnedGroup {
  std::string name;                  ///< a path, or a pattern that matches no device with other times, except by name
  std::vector<std::uint32_t> units;  ///< ascending
  LearnedDevice times;               ///< of the first one, made of the moves of all
};

/// How long the moves of one transition of one device took on average.
struct Baseline {
  std::uint32_t unit = kNone;
  std::uint32_t from = kNone;
  std::uint32_t to = kNone;
  std::uint32_t transition = kNone;  ///< kNone: a spring's return
  const char* span = "";             ///< `after`, `takes` or `total`
  std::size_t count = 0;
  Time mean = 0;
  Time deviation = 0;  ///< standard, of the sample
};

/// A name in a recording that is no symbol of the plant.
struct UnknownName {
  std::string name;
  std::string nearest;  ///< a symbol; empty: none is similar
  std::uint32_t input = 0;
};

/// Why many moves of a device are not used.
enum class UnusedReason : std::uint8_t {
  few,           ///< not many are
  inverted,      ///< they have a cause if the operations of the device are inverted
  not_recorded,  ///< no recording has one of its operations
  unknown,
};

/// The moves of a device of which some are not used.
struct UnusedMoves {
  std::uint32_t unit = kNone;
  std::size_t used = 0;
  std::size_t turned = 0;    ///< turned round, or not certain
  std::size_t uncaused = 0;  ///< nothing in the model caused them
  UnusedReason reason = UnusedReason::few;

  std::size_t unused() const { return turned + uncaused; }
  std::size_t all() const { return used + unused(); }
};

/// What the recordings do not show. All by index in the plant, ascending.
struct NotSeen {
  std::vector<std::uint32_t> devices;                                ///< units that could move and never did
  std::vector<std::pair<std::uint32_t, std::uint32_t>> transitions;  ///< unit, transition: of units that moved
  std::vector<std::uint32_t> events;                                 ///< recorded, and never changed
  std::vector<std::uint32_t> symbols;                                ///< in no recording
  std::vector<UnknownName> names;
};

struct Learned {
  const model::PlantModel* plant = nullptr;  ///< must outlive this
  std::vector<Source> sources;
  std::vector<LearnedGroup> groups;  ///< by first unit
  std::vector<Baseline> baselines;   ///< by unit and transition
  NotSeen not_seen;
  Pairs pairs;
  std::size_t moves = 0;                  ///< with the times of a transition
  std::size_t unused = 0;                 ///< moves that turned round, or that nothing in the model caused
  std::vector<UnusedMoves> unused_moves;  ///< by unit: those of which some are not used
};

}  // namespace symplant::learn
