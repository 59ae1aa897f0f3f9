// A conversation with one PLC in some protocol: the interface between a client link's thread and its protocols.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/link/client/retry.hpp"
#include "symplant/link/image/images.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/refusal.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// Why a step did not succeed.
struct Fault {
  enum class Kind : std::uint8_t {
    none,
    transport,    ///< no or no valid answer: the connection must be closed, since a late answer could follow
    rejected,     ///< the PLC answered with an error; the connection is good
    interrupted,  ///< by interrupt()
  };
  Kind kind = Kind::none;
  std::string message = {};  ///< what happened and what to do

  explicit operator bool() const noexcept { return kind != Kind::none; }
};

/// 16 positions of a plane of bits, or 16 bits of a number: the unit in which changes are written. Its bits are lane
/// `number` of the plane's words (image::get_lane).
struct Lane {
  Plane plane = Plane::event_bits;
  std::uint32_t number = 0;  ///< of bits: position / 16; of numbers: 4 * position + 0 to 3, the lowest bits first
  friend bool operator==(const Lane&, const Lane&) = default;
};

/// A change to be written to a lane: the bits of `mask` get their values from `value`.
struct LaneChange {
  Lane lane;
  std::uint16_t mask = 0;
  std::uint16_t value = 0;
};

using image::kLaneBits;

/// Whether both name a common bit of the same lane.
inline bool meet(const LaneChange& one, const LaneChange& other) {
  return one.lane == other.lane && (one.mask & other.mask) != 0;
}

/// The two planes of one direction, to be changed.
struct Words {
  std::span<std::uint64_t> bits;
  std::span<std::uint64_t> numbers;
};

/// Sees the requests of readings, one by one.
class ReadObserver {
 public:
  ReadObserver() = default;
  ReadObserver(const ReadObserver&) = delete;
  ReadObserver& operator=(const ReadObserver&) = delete;
  virtual ~ReadObserver() = default;

  /// The planes in which the dialog sets all bits of what a request has read, before it calls answered().
  virtual Words marks() noexcept = 0;
  /// A request was answered, and its values are in the planes of the reading. Times are of the steady clock, in ns:
  /// before the request was sent, and when its answer was complete.
  virtual void answered(tables::Time sent, tables::Time answered) = 0;
};

/// The events to be written.
struct Events {
  std::span<const std::uint64_t> bits;
  std::span<const std::uint64_t> numbers;

  std::span<const std::uint64_t> of(Plane plane) const noexcept { return plane == Plane::event_bits ? bits : numbers; }
};

/// A request that the PLC did not do.
struct Rejection {
  Answer answer = Answer::refused;  ///< or busy
  tables::Refusal refusal;
  std::string message;  ///< what the PLC refuses, why, and what to do
};

/// Bits of a lane that the PLC did not take, and why.
struct Unwritten {
  LaneChange change;
  Answer answer = Answer::refused;  ///< or busy
  tables::Refusal refusal = {};
};

/// Bits of a lane of operations that are left out, since the PLC permanently refuses to read them.
struct LeftOut {
  LaneChange lanes;  ///< without a value
  tables::Refusal refusal;
};

/// Whether the PLC is the one that the link was configured for.
struct Identity {
  enum class Kind : std::uint8_t {
    verified,
    unverifiable,  ///< the PLC or the protocol has nothing to compare: writing needs `--arm`
    wrong,         ///< another PLC: the link must not write
  };
  Kind kind = Kind::unverifiable;
  std::string message = {};  ///< what was found: "CPU `R08CPU`"
};

/// One connection at a time to one PLC. Used by the thread of a client link; interrupt() may be called by any thread.
class Dialog {
 public:
  Dialog() = default;
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;
  virtual ~Dialog() = default;

  virtual std::string url() const = 0;

  /// Connects. After a fault the dialog is closed.
  virtual Fault open() = 0;
  virtual void close() noexcept = 0;
  /// Asks the PLC what it is. `fault` is set if there was no valid answer.
  virtual Identity identify(Fault& fault) = 0;

  /// Reads all mapped operations into the planes. A fault of the transport leaves some unread. If the PLC refuses a
  /// request, the other requests are still sent, and Retry and RequestList define when the refused one is sent again.
  /// `now` is the time of the pass, in ns. The result is `rejected` if the PLC refused all requests, or if it is not
  /// known yet which symbols it refuses.
  virtual Fault read(const Words& operations, tables::Time now) = 0;
  /// Writes the changes, which are in ascending order of lanes and within the map. Adds those that the PLC did not take
  /// to `unwritten`.
  virtual Fault write(std::span<const LaneChange> changes, std::vector<Unwritten>& unwritten) = 0;
  /// Reads what the PLC holds where events are written; otherwise as read().
  virtual Fault read_back(const Words& events, tables::Time now) = 0;

  /// From now on the observer sees each answered request of read() and read_back(). Null: none. It must outlive its
  /// last reading.
  virtual void observe(ReadObserver* observer) noexcept = 0;
  /// Makes all refused requests to read due now.
  virtual void retry_rejected() noexcept = 0;
  /// Whether it is not known yet which symbols the PLC refuses: the next calls of read() and read_back() find that out.
  virtual bool is_dividing() const noexcept = 0;
  /// The requests that were refused since the last call. A request to read appears only at its first refusal in a row.
  virtual std::vector<Rejection> take_rejections() = 0;
  /// The bits that have been left out since the last call.
  virtual std::vector<LeftOut> take_left_out() = 0;
  /// Which functions of the protocol the link needs, and which of them the PLC has as far as it was asked; empty if all
  /// PLCs have the same.
  virtual std::string functions() const { return {}; }

  /// Ends the current call and all later ones. Any thread.
  virtual void interrupt() noexcept = 0;
  /// Number of answered requests, rejected ones included. Any thread.
  virtual std::uint64_t requests() const noexcept = 0;
  /// Number of rejected requests. Any thread.
  virtual std::uint64_t rejected() const noexcept = 0;
};

}  // namespace symplant::link::client
