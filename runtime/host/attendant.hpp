// Who looks after a run in real time, on a thread that is not the cycle's: status line, SIGUSR1, systemd.
#pragma once

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/service_manager.hpp"

namespace symplant::host {

/// "1230 cycles, p99 85.2 us late, 0 overruns; PLC1 live, PLC2 waiting".
/// `degraded`: the system refused what was asked for, which is said, too.
std::string status_text(const exec::CycleMeter& meter, const std::vector<std::string>& links, bool degraded);

/// From its making to its end it draws a status line on `out` once a second where that is a terminal, writes one line
/// of it for each SIGUSR1, and tells the service manager: READY=1 when the cycle goes, STOPPING=1 when it is to end,
/// WATCHDOG=1 as long as it goes on.
class Attendant {
 public:
  Attendant(const exec::CycleMeter& meter, const Links& links, const RunOptions& options, bool degraded,
            std::ostream& out);
  Attendant(const Attendant&) = delete;
  Attendant& operator=(const Attendant&) = delete;
  ~Attendant();

 private:
  void attend(const std::stop_token& stop);
  void tell_manager();
  void tell_user(bool line_is_due);

  const exec::CycleMeter& meter_;
  std::ostream& out_;
  std::vector<std::string> links_;
  bool degraded_;
  bool terminal_;
  bool drawn_ = false;
  ServiceManager manager_;
  bool ready_ = false;
  bool stopping_ = false;
  std::uint64_t beats_ = 0;  ///< when the watchdog was told last
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace symplant::host
