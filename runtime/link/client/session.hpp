// The exchange of a client link with its PLC, pass by pass.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/messages.hpp"
#include "symplant/link/client/outbox.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/client/write_retries.hpp"
#include "symplant/link/image/images.hpp"
#include "symplant/link/link.hpp"
#include "symplant/share/ring.hpp"

namespace symplant::link::client {

/// Reads the operations and writes the events over a dialog that is open. It has no thread and no clock: `now` is the
/// time of a call in ns, of any clock that does not go back. All members are for one thread, except those that say
/// otherwise.
class Session {
 public:
  /// Dialog, tables and images must outlive it. `arm`: write also to a PLC that has nothing to verify.
  Session(Dialog& dialog, const tables::PlantTables& tables, const image::Map& map, const ClientTimes& times,
          image::Images& images, bool arm);

  /// After each connection, before its first pass: asks the PLC what it is.
  Fault begin(tables::Time now);
  /// Reads all, then writes what changed or compares what was written. A fault ends the connection. `losses`: of the
  /// link so far; `leaving`: the plant has ended.
  Fault pass(tables::Time now, std::uint32_t losses, bool leaving);
  /// Whether this connection has brought a complete reading.
  bool has_passed() const noexcept { return passed_; }

  /// Number of complete readings of the operations. Any thread.
  std::uint64_t signs() const noexcept { return signs_.load(std::memory_order_acquire); }
  /// Whether it may write to the PLC. Any thread.
  bool is_armed() const noexcept { return armed_.load(std::memory_order_relaxed); }
  /// Whether the events were written in a pass with `leaving`. Any thread.
  bool has_left() const noexcept { return left_.load(std::memory_order_relaxed); }
  /// Any thread.
  Messages& messages() noexcept { return messages_; }
  /// The next finding about the PLC; nothing if there is no new one. Wait-free; for one other thread.
  std::optional<LinkFinding> take_finding() noexcept;

 private:
  bool may_write(const Identity& identity);
  Fault read(tables::Time now, std::uint32_t losses);
  Fault write(const Events& events, tables::Time now);
  Fault write_refused(const Events& events, tables::Time now);
  Fault look_back(tables::Time now);
  Events events(bool leaving);
  void report_refused();
  void report_lanes(tables::FindingKind kind, const LaneChange& lanes, std::uint64_t value);
  void report(const LinkFinding& finding);
  void offer() noexcept;

  Dialog& dialog_;
  image::Images& images_;
  const tables::PlantTables& tables_;
  const std::vector<image::Point> points_;
  const ClientTimes times_;
  const bool arm_;
  Outbox outbox_;
  WriteRetries retries_;
  std::vector<std::uint64_t> zeros_;
  std::vector<std::uint64_t> bits_;  ///< events as read back
  std::vector<std::uint64_t> numbers_;
  std::vector<LaneChange> suspects_;  ///< differences of the latest look back
  std::vector<Unwritten> unwritten_;  ///< of the latest request to write
  tables::Time next_refresh_ = 0;
  tables::Time next_look_back_ = 0;
  bool passed_ = false;
  bool wrote_ = false;  ///< the latest pass
  Messages messages_;
  std::vector<LinkFinding> to_report_;                                ///< for which the ring had no room
  std::set<std::pair<tables::FindingKind, std::uint64_t>> reported_;  ///< by symbol, or by packed refusal
  share::Ring<LinkFinding> findings_{64};
  std::atomic<std::uint64_t> signs_{0};
  std::atomic<bool> armed_{false};
  std::atomic<bool> left_{false};
};

}  // namespace symplant::link::client
