// The parts of an SlmpPlc together: sockets, scan thread, state. Only for slmp_plc.cpp and plc_server.cpp.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "support/slmp/plc_commands.hpp"
#include "support/slmp/slmp_plc.hpp"

namespace symplant::test::slmp {

class SlmpPlc::Server : public PeerHandler {
 public:
  Server(PlcOptions options, DeliveryHook hook);
  ~Server() override;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::size_t received(const Peer& peer, std::span<const std::uint8_t> bytes, std::vector<Delivery>& out) override;
  void accepted(const Peer& peer) override;
  void refused_connection() override;
  void closed(const Peer& peer) override;

  void scan_once();
  void set_running(bool on);
  void set_terminal(std::uint32_t x_number, bool on);
  bool wait_until(const std::function<bool()>& holds, std::chrono::milliseconds patience) const;

  PlcMemory memory;
  PlcLog log;
  std::atomic<bool> is_silent{false};
  std::atomic<bool> writes_in_run;
  std::atomic<std::uint64_t> scans{0};
  std::atomic<std::size_t> refused_connections{0};
  std::unique_ptr<PlcSockets> sockets;

 private:
  void answer(const Peer& peer, const RequestFrame& request, std::vector<Delivery>& out);
  void note_violations(const Outcome& outcome);
  void note_requests(const Peer& peer, std::span<const std::uint8_t> bytes);
  void log_without_reply(const Peer& peer, const RequestFrame& request);
  void write_run_state();
  void scan_loop();
  void changed();

  PlcOptions options_;
  DeliveryHook hook_;
  Cpu cpu_;
  std::map<std::size_t, std::size_t> unanswered_;  ///< requests of a connection; server's thread only

  std::mutex scan_mutex_;  ///< held during a scan and while a request is served
  bool is_running_ = true;
  std::set<std::uint32_t> terminals_;  ///< numbers of X that are on

  mutable std::mutex change_mutex_;
  mutable std::condition_variable change_;
  std::uint64_t changes_ = 0;
  bool stops_ = false;
  std::thread scan_thread_;
};

}  // namespace symplant::test::slmp
