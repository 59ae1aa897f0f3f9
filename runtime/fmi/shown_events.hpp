// The BOOL events that an importer sees at the communication points: a pulse shorter than a step is held to its end,
// once.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/engine/instant.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::fmi {

/// An event that differed from what was shown last at any time in a step is shown as the opposite at its end, even if
/// it is back by then. So an importer sees an edge of each pulse, and the plant's real value at the latest one step
/// after the last change. Of several pulses of an event in one step it sees one; all are counted. Not thread-safe.
class ShownEvents {
 public:
  /// Shows the plant's events as they are, with no pulse counted. O(events).
  void restart(const plant::Plant& plant);

  /// To be called before the instants of a step. O(events held by the step before).
  void begin(const plant::Plant& plant);
  /// To be called for each instant of the step. O(changed words).
  void see(const plant::Plant& plant, const engine::Instant& instant) noexcept;
  /// To be called after them. O(changed words).
  void end(const plant::Plant& plant);

  bool shows(std::uint32_t bit) const noexcept { return (shown_[bit / 64] >> bit % 64 & 1) != 0; }
  /// Pulses shorter than their step since restart().
  std::uint64_t short_pulses() const noexcept { return short_pulses_; }
  /// The bits that show the end of the last step differently from the plant. O(those).
  std::vector<std::uint32_t> held(const plant::Plant& plant) const;

  /// The state at a communication point, as numbers. O(events).
  std::vector<std::uint64_t> save() const;
  /// Restores it, after the plant. False, and nothing changes, if it is of another number of events. O(events).
  bool restore(const std::vector<std::uint64_t>& numbers, const plant::Plant& plant);

 private:
  void differ(std::uint32_t word, std::uint64_t bits) noexcept;

  std::vector<std::uint64_t> shown_;    ///< at the last communication point
  std::vector<std::uint64_t> seen_;     ///< bits that have differed from it in this step
  std::vector<std::uint32_t> touched_;  ///< words with such bits; of a size that holds all
  std::vector<std::uint32_t> held_;     ///< words of which the plant differed at the end of the last step
  std::uint64_t short_pulses_ = 0;
};

}  // namespace symplant::fmi
