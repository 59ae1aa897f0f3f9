// systemd, told how the run stands, by the datagrams of sd_notify(3).
#pragma once

#include <cstdint>
#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::host {

/// Whoever started the program as a service and gave it NOTIFY_SOCKET: a path, or an abstract name behind `@`. Nobody
/// is told where it is not set, and where nobody hears it nothing goes wrong.
class ServiceManager {
 public:
  /// From NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment; the latter two count where they are meant
  /// for this process.
  static ServiceManager of_environment();
  /// `socket` as in NOTIFY_SOCKET, empty: nobody listens.
  ServiceManager(const std::string& socket, tables::Time watchdog);
  ServiceManager(ServiceManager&& other) noexcept;
  ServiceManager& operator=(ServiceManager&&) = delete;
  ~ServiceManager();

  bool listens() const noexcept { return socket_ >= 0; }
  /// Silence of this length has the program killed; 0: it may be as silent as it likes.
  tables::Time watchdog() const noexcept { return watchdog_; }

  /// `state`: lines such as `READY=1`. Never waits; false where it did not go out, since the manager is behind with
  /// what it was told, say.
  bool report(const std::string& state) const noexcept;

 private:
  int socket_ = -1;
  tables::Time watchdog_ = 0;
};

}  // namespace symplant::host
