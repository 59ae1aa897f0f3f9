// The changes of an instant, and the observer that receives them.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/tables/finding.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// A 64-bit word of a bit plane that an instant changed, and the bits that changed.
struct WordChange {
  std::uint32_t word;
  std::uint64_t bits;
};

/// The net changes of one instant, after forces. Valid only during the call of the observer.
struct Instant {
  tables::Time time;
  std::span<const std::uint32_t> units;    ///< units that may have changed, each once, in no order
  std::span<const WordChange> operations;  ///< each changed word once, in no order
  std::span<const WordChange> events;
  std::span<const std::uint32_t> operation_slots;  ///< slots whose values changed
  std::span<const std::uint32_t> event_slots;
};

/// Receives every instant with a change, and every finding. It is called during advance_to() and advance_before(): its
/// functions must be bounded.
class Observer {
 public:
  /// It may read the plant and must not act on it.
  virtual void instant(const Instant& instant) noexcept = 0;
  /// A finding of the instant of the next instant() call, in order of FindingKind. No finding is lost here, unlike in
  /// the ring that take_finding() reads.
  virtual void finding(const tables::Finding&) noexcept {}

 protected:
  ~Observer() = default;
};

}  // namespace symplant::engine
