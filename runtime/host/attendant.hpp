// Serves the user and the service manager during a run in real time: status line, SIGUSR1, systemd.
#pragma once

#include <chrono>
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
#include "symplant/host/waits.hpp"

namespace symplant::host {

/// "1230 cycles, late by 85.2 us (p99), 0 overruns; PLC1 live, PLC2 waiting", with ", real time degraded" if `degraded`
/// (the system refused a requested real-time setting), "; plant time 3.2 ms behind the PLC, 12 waits, 0 restarts" if it
/// follows a PLC's clock, and "; the plant is frozen" at the end if it is.
std::string status_text(const exec::CycleMeter& meter, const std::vector<std::string>& links, bool degraded);

/// Whether a status line can be drawn on `out`: it is a terminal, and no output file is written to it.
bool can_draw(const RunOptions& options, const std::ostream& out);

/// From construction to destruction, on its own thread: draws a status line on `console` once per second if `draws`,
/// writes it as a line for each SIGUSR1, writes what links report and what the plant waits for, and notifies the
/// service manager: READY=1 when the cycle runs, STOPPING=1 when it is to end, WATCHDOG=1 while it makes progress.
class Attendant {
 public:
  Attendant(const exec::CycleMeter& meter, const Links& links, Waits waits, bool degraded, bool draws,
            Console& console);
  Attendant(const Attendant&) = delete;
  Attendant& operator=(const Attendant&) = delete;
  ~Attendant();

 private:
  void attend(const std::stop_token& stop);
  void report_ready();
  void report_manager();
  void report_user(bool line_is_due);
  void report_links();
  void report_waits();

  const exec::CycleMeter& meter_;
  Console& console_;
  std::vector<std::string> links_;
  std::vector<link::Link*> reporting_;
  Waits waits_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool degraded_;
  bool draws_;
  ServiceManager manager_;
  bool ready_ = false;
  bool stopping_ = false;
  std::uint64_t beats_ = 0;  ///< count of beats at the last WATCHDOG=1
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace symplant::host
