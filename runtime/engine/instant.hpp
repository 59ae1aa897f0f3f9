// What an instant changed, for those that watch a running plant.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/tables/finding.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// A 64-bit word of a bit plane that an instant changed, and which of its bits.
struct WordChange {
  std::uint32_t word;
  std::uint64_t bits;
};

/// The net effect of all that happened at one time, on the effective side (after forces). Valid only while the observer
/// is called.
struct Instant {
  tables::Time time;
  std::span<const std::uint32_t> units;    ///< that may have changed, each once, in no order
  std::span<const WordChange> operations;  ///< by word, in no order
  std::span<const WordChange> events;
  std::span<const std::uint32_t> operation_slots;  ///< values that changed
  std::span<const std::uint32_t> event_slots;
};

/// Is told of every instant in which anything changed. Called inside advance_to: bounded and noexcept.
class Observer {
 public:
  /// It may read the plant and must not act on it.
  virtual void instant(const Instant& instant) noexcept = 0;
  /// A finding of the instant that instant() is called for next, in their order (see FindingKind). Unlike the ring
  /// behind take_finding() it misses none.
  virtual void finding(const tables::Finding&) noexcept {}

 protected:
  ~Observer() = default;
};

}  // namespace symplant::engine
