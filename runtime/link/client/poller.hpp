// The thread of a client link: connects, and lets a session read operations and write events.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/client/session.hpp"
#include "symplant/link/image/images.hpp"

namespace symplant::link::client {

/// Runs from its construction to its destruction. Only its thread may use the images' members for the link's thread.
class Poller {
 public:
  /// `arm`: write also to a PLC that has nothing to verify. Throws std::system_error if there is no thread left.
  /// `note`: the first message to the user, if not empty.
  Poller(ClientParts parts, const tables::PlantTables& tables, image::Images& images, bool arm, std::string note);
  Poller(const Poller&) = delete;
  Poller& operator=(const Poller&) = delete;
  ~Poller();

  std::string url() const { return dialog_->url(); }
  /// Number of complete readings of the operations. Any thread.
  std::uint64_t signs() const noexcept { return session_.signs(); }
  /// Sets the number of losses so far. Any thread.
  void lost(std::uint32_t losses) noexcept { losses_.store(losses, std::memory_order_relaxed); }
  /// While it is cut, it closes its connection and opens none. Any thread, wait-free.
  void cut(bool on) noexcept { cut_.store(on, std::memory_order_relaxed); }
  /// The plant has ended: the events are written once more. Any thread.
  void leave() noexcept { leaving_.store(true, std::memory_order_release); }
  /// For the cycle's thread, wait-free.
  std::optional<LinkFinding> take_finding() noexcept { return session_.take_finding(); }
  std::vector<std::string> take_messages() { return session_.messages().take(); }
  LinkStatus status() const noexcept;

 private:
  void run(const std::stop_token& stop);
  Fault talk(const std::stop_token& stop);
  bool sleep(const std::stop_token& stop, tables::Time duration);

  std::unique_ptr<Dialog> dialog_;
  const ClientTimes times_;
  Session session_;
  std::atomic<std::uint32_t> losses_{0};
  std::atomic<std::uint32_t> connections_{0};
  std::atomic<bool> reached_{false};
  std::atomic<bool> leaving_{false};
  std::atomic<bool> cut_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // last member: it uses the others
};

}  // namespace symplant::link::client
