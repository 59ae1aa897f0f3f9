// The thread of a client link: connects, reads operations, writes events.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "symplant/link/client/messages.hpp"
#include "symplant/link/client/outbox.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/images.hpp"

namespace symplant::link::client {

/// Runs from its construction to its destruction. The images' members for the other thread are its own.
class Poller {
 public:
  /// `arm`: write also to a PLC that has nothing to verify. Throws std::system_error if there is no thread left.
  /// `note`: the first message to the user, if not empty.
  Poller(ClientParts parts, image::Images& images, bool arm, std::string note);
  Poller(const Poller&) = delete;
  Poller& operator=(const Poller&) = delete;
  ~Poller();

  std::string url() const { return dialog_->url(); }
  /// Number of complete readings of the operations. Any thread.
  std::uint64_t signs() const noexcept { return signs_.load(std::memory_order_acquire); }
  /// Sets the number of losses so far. Any thread.
  void lost(std::uint32_t losses) noexcept { losses_.store(losses, std::memory_order_relaxed); }
  /// While it is cut, it closes its connection and opens none. Any thread, wait-free.
  void cut(bool on) noexcept { cut_.store(on, std::memory_order_relaxed); }
  /// The plant has ended: the events are written once more. Any thread.
  void leave() noexcept { leaving_.store(true, std::memory_order_release); }
  /// A symbol whose event the PLC overwrites, which was not returned before; else tables::kNone. Wait-free.
  std::uint32_t take_overwritten() noexcept { return overwritten_.exchange(tables::kNone, std::memory_order_acquire); }
  std::vector<std::string> take_messages() { return messages_.take(); }
  LinkStatus status() const noexcept;

 private:
  void run(const std::stop_token& stop);
  Fault talk(const std::stop_token& stop);
  bool may_write(const Identity& identity);
  Fault pass(bool writes);
  Fault write(const image::Tables& tables);
  Fault look_back();
  void note_overwritten(const std::vector<LaneChange>& lanes);
  void offer_overwritten() noexcept;
  bool sleep(const std::stop_token& stop, tables::Time duration);

  std::unique_ptr<Dialog> dialog_;
  image::Images& images_;
  const std::vector<IoPoint> points_;
  const ClientTimes times_;
  const bool arm_;
  Outbox outbox_;
  std::vector<std::uint64_t> zeros_;
  std::vector<std::uint64_t> discrete_inputs_;  ///< as read back
  std::vector<std::uint64_t> input_registers_;
  std::vector<LaneChange> suspects_;      ///< differences of the latest look back
  std::vector<std::uint32_t> to_report_;  ///< symbols that were overwritten
  std::vector<bool> reported_;            ///< by index in points_
  tables::Time next_refresh_ = 0;
  tables::Time next_look_back_ = 0;
  bool passed_ = false;  ///< the current connection has brought a complete reading
  Messages messages_;
  std::atomic<std::uint64_t> signs_{0};
  std::atomic<std::uint32_t> losses_{0};
  std::atomic<std::uint32_t> connections_{0};
  std::atomic<bool> reached_{false};
  std::atomic<std::uint32_t> overwritten_{tables::kNone};
  std::atomic<bool> armed_{false};
  std::atomic<bool> leaving_{false};
  std::atomic<bool> cut_{false};
  std::atomic<bool> left_{false};  ///< the events were written after leave()
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // last member: it uses the others
};

}  // namespace symplant::link::client
