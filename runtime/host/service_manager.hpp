// Notifies systemd of the state of the run, by datagrams of sd_notify(3).
#pragma once

#include <cstdint>
#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::host {

/// The service manager that started the program and set NOTIFY_SOCKET: a path, or an abstract name after `@`. Without
/// NOTIFY_SOCKET, or without a listener there, notifications do nothing.
class ServiceManager {
 public:
  /// From NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment. WATCHDOG_USEC is ignored if WATCHDOG_PID is
  /// another process.
  static ServiceManager of_environment();
  /// `socket` as in NOTIFY_SOCKET; empty: no notifications.
  ServiceManager(const std::string& socket, tables::Time watchdog);
  ServiceManager(ServiceManager&& other) noexcept;
  ServiceManager& operator=(ServiceManager&&) = delete;
  ~ServiceManager();

  bool listens() const noexcept { return socket_ >= 0; }
  /// The manager kills the program after this time without WATCHDOG=1; 0: never.
  tables::Time watchdog() const noexcept { return watchdog_; }

  /// Sends `state`: lines such as `READY=1`. Never waits; false if it was not sent, for example because the queue of
  /// the manager is full.
  bool report(const std::string& state) const noexcept;

 private:
  int socket_ = -1;
  tables::Time watchdog_ = 0;
};

}  // namespace symplant::host
