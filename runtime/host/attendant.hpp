// Who looks after a run in real time, on a thread that is not the cycle's: status line, SIGUSR1, systemd.
#pragma once

#include <condition_variable>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/service_manager.hpp"

namespace symplant::host {

/// "1230 cycles, p99 85.2 us late, 0 overruns; PLC1 live, PLC2 waiting".
/// A plant that stands still with a lost link says so at the end. `degraded`: the system refused what was asked for,
/// which is said, too.
std::string status_text(const exec::CycleMeter& meter, const std::vector<std::string>& links, bool degraded);

/// Whether a status line can be drawn on `out`: it is a terminal, and no file goes there.
bool can_draw(const RunOptions& options, const std::ostream& out);

/// From its making to its end it draws a status line on `console` once a second where `draws`, writes one line
/// of it for each SIGUSR1 as soon as that is taken, and tells the service manager: READY=1 when the cycle goes,
/// STOPPING=1 when it is to end, WATCHDOG=1 as long as it goes on.
class Attendant {
 public:
  Attendant(const exec::CycleMeter& meter, const Links& links, bool degraded, bool draws, Console& console);
  Attendant(const Attendant&) = delete;
  Attendant& operator=(const Attendant&) = delete;
  ~Attendant();

 private:
  void attend(const std::stop_token& stop);
  void report_ready();
  void report_manager();
  void report_user(bool line_is_due);

  const exec::CycleMeter& meter_;
  Console& console_;
  std::vector<std::string> links_;
  bool degraded_;
  bool draws_;
  ServiceManager manager_;
  bool ready_ = false;
  bool stopping_ = false;
  std::uint64_t beats_ = 0;  ///< when the watchdog was told last
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace symplant::host
