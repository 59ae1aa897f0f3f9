// What an explanation reads of a running plant: an interface, since the state may come from different sources.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/trace/history.hpp"

namespace symplant::why {

/// A part at a location.
struct PartState {
  std::uint64_t number = 0;
  std::uint32_t kind = 0;
  tables::Time since = 0;         ///< when it came there
  std::optional<std::int64_t> x;  ///< on a track: its front, in um; nothing: unknown
  std::int64_t speed = 0;         ///< on a track: um/s, < 0: backward; valid only with `x`
  std::uint32_t drive = 0;        ///< of the track: the one that moves it; valid only with `x`
};

/// The state of a plant at the end of an instant. Values are after forces. Members that return an optional return
/// nothing if the value is unknown; an explanation is then less detailed.
class StateView {
 public:
  virtual ~StateView() = default;

  virtual tables::Time now() const = 0;
  /// Its `remaining` and `progress` are not read: see remaining().
  virtual plant::UnitView unit(std::uint32_t unit) const = 0;
  virtual tables::Time unit_since(std::uint32_t unit) const = 0;  ///< when its state changed last; 0: never
  virtual std::uint64_t value(std::uint32_t symbol) const = 0;
  virtual tables::Time since(std::uint32_t symbol) const = 0;    ///< when its value changed last; 0: never
  virtual tables::Time rose(std::uint32_t operation) const = 0;  ///< when it last began to command; -1: never
  /// On a track from the front-most one, if positions are known; else in the order in which they came.
  virtual std::vector<PartState> parts(std::uint32_t location) const = 0;

  virtual std::optional<double> output(std::uint32_t) const { return {}; }  ///< of a value
  /// The sum of the weights of the parts at a location.
  virtual std::optional<double> weight(std::uint32_t) const { return {}; }

  /// How long a unit still moves.
  virtual std::optional<tables::Time> remaining(std::uint32_t) const { return {}; }
  /// As Plant::after_left().
  virtual std::optional<tables::Time> after_left(std::uint32_t, std::uint16_t) const { return {}; }
  /// Whether a BOOL operation that is on has an effect, or must be off first.
  virtual std::optional<bool> is_armed(std::uint32_t) const { return {}; }
  virtual std::optional<bool> is_pending(std::uint32_t) const { return {}; }  ///< a requirement
  virtual std::optional<bool> is_frozen_track(std::uint32_t) const { return {}; }
  virtual std::optional<plant::TransferView> transfer(std::uint32_t) const { return {}; }
  virtual std::optional<plant::SourceView> source(std::uint32_t) const { return {}; }

  /// False: explanations do not name malfunctions, as for a trainee.
  virtual bool shows_malfunctions() const { return true; }
  /// The active malfunctions in the order in which they started; empty if they are not shown.
  virtual std::span<const trace::History::Malfunction> malfunctions() const { return {}; }

  // The rest are phrases that end a sentence; empty: there is nothing to say.
  /// Of a forced symbol: `since 3 s`, as in "is forced to on since 3 s".
  virtual std::string forced(std::uint32_t) const { return {}; }
  /// Why an operation is not written: `no link carries it`.
  virtual std::string unwritten(std::uint32_t) const { return {}; }
  /// Of a requirement that was violated: `was violated at 3 s`.
  virtual std::string violated(std::uint32_t) const { return {}; }
  /// Why the whole plant does not run: `link modbus-tcp-server://:502 is lost, and the plant is frozen`.
  virtual std::string standstill() const { return {}; }
};

}  // namespace symplant::why
