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

/// A part of the material flow that was made, moved to another location, or changed its kind.
struct PartChange {
  enum class What : std::uint8_t { made, moved, changed };
  std::uint64_t number;
  std::uint32_t kind;  ///< afterwards
  std::uint32_t from;  ///< only if it moved: a location
  std::uint32_t to;    ///< not if it changed: a location, or tables::kOut
  std::int64_t x;      ///< on a track: its front, in um, rounded down
  What what;
  bool by_hand;  ///< by Plant::put() or Plant::take()
};

/// A malfunction that started or ended.
struct MalfunctionChange {
  enum class By : std::uint8_t {
    scenario,
    hand,
    condition,  ///< its `when` began to hold, or its `unless` held
    chance,
    becomes,  ///< another one became this one, or this one another
    end,      ///< its time `lasts` is over
  };
  std::uint32_t malfunction;  ///< as tables::MalfunctionNumbers numbers them
  bool active;                ///< it started
  By by;
};

/// The engine reports at least this many changes of parts by hand between two instants, and as many of malfunctions.
/// Further changes are missing in its Instant.
inline constexpr std::uint32_t kMostByHand = 1024;

/// The net changes of one instant, after forces. Valid only during the call of the observer.
struct Instant {
  tables::Time time;
  std::span<const std::uint32_t> units;    ///< units that may have changed, each once, in no order
  std::span<const WordChange> operations;  ///< each changed word once, in no order
  std::span<const WordChange> events;
  std::span<const std::uint32_t> operation_slots;  ///< slots whose values changed
  std::span<const std::uint32_t> event_slots;
  std::span<const PartChange> parts;      ///< in the order in which they happened
  std::span<const std::uint32_t> tracks;  ///< those whose parts came, left or changed their speeds, in no order
  std::span<const MalfunctionChange> malfunctions;  ///< in the order in which they happened
  std::span<const std::uint32_t> values;            ///< outputs of values that a trace shows now and that changed
};

/// Receives every instant with a change, every instant at which a trace may show values that changed before, every
/// instant that is followed by another one at the same time, and every finding. It is called during advance_to() and
/// advance_before(): its functions must be bounded.
class Observer {
 public:
  /// It may read the plant and must not act on it.
  virtual void instant(const Instant& instant) noexcept = 0;
  /// Changes of parts of the next instant() call that exceed the engine's list of one instant; they happened before
  /// those of instant().
  virtual void parts_before(tables::Time, std::span<const PartChange>) noexcept {}
  /// A finding of the instant of the next instant() call, in order of FindingKind. No finding is lost here, unlike in
  /// the ring that take_finding() reads.
  virtual void finding(const tables::Finding&) noexcept {}

 protected:
  ~Observer() = default;
};

}  // namespace symplant::engine
