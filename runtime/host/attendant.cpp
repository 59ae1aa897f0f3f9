// Serves the user and the service manager during a run in real time.
#include "symplant/host/attendant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

#include "symplant/host/files_apart.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/terminal.hpp"
#include "symplant/host/words.hpp"

namespace symplant::host {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr tables::Time kTurn = 100 * tables::kMillisecond;
constexpr auto kLinePeriod = std::chrono::seconds(1);
constexpr std::size_t kUsualWidth = 79;

/// The longest status line, in columns: a line wider than the terminal could not be redrawn.
std::size_t terminal_width() {
  const std::size_t columns = terminal_columns();
  return columns > 1 ? columns - 1 : kUsualWidth;
}

std::string phase_text(const exec::PlcClockReading& clock) {
  if (clock.values == 0) return "; plant time waits for the PLC's clock";
  return fmt::format(
      "; plant time {:.1f} ms {} the PLC, {}, {}", std::abs(static_cast<double>(clock.phase_error)) / 1e6,
      clock.phase_error < 0 ? "behind" : "ahead of", plural(clock.waits, "wait"), plural(clock.restarts, "restart"));
}

}  // namespace

bool can_draw(const RunOptions& options, const std::ostream& out) {
  return &out == &std::cout && !uses_standard_output(options) && is_terminal(Stream::output) && can_redraw_lines();
}

std::string status_text(const exec::CycleMeter& meter, const std::vector<std::string>& links, bool degraded) {
  std::string text = fmt::format("{} cycles, late by {:.1f} us (p99), {} overruns", meter.cycles.value(),
                                 static_cast<double>(meter.lateness.durations().p99) / 1e3, meter.overruns.value());
  if (degraded) text += ", real time degraded";
  for (std::size_t i = 0; i < std::min(links.size(), exec::CycleMeter::kMostLinks); ++i) {
    text += (i == 0 ? "; " : ", ") + links[i] + " " + state_name(meter.state(i));
  }
  if (const auto clock = meter.plc_clock()) text += phase_text(*clock);
  if (meter.is_stopped()) text += "; the plant is frozen";
  return text;
}

Attendant::Attendant(const exec::CycleMeter& meter, const Links& links, Waits waits, bool degraded, bool draws,
                     Console& console)
    : meter_(meter),
      console_(console),
      waits_(std::move(waits)),
      degraded_(degraded),
      draws_(draws),
      manager_(ServiceManager::of_environment()) {
  for (const OpenLink& open : links) {
    links_.push_back(open.controller.empty() ? "link" : open.controller);
    reporting_.push_back(open.link.get());
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { attend(stop); });
}

Attendant::~Attendant() {
  thread_.request_stop();
  thread_.join();
  report_links();
  report_waits();
  if (console_.is_taken()) console_.clear();
  report_ready();  // a run may be shorter than a turn
  if (!stopping_) manager_.report("STOPPING=1");
}

void Attendant::attend(const std::stop_token& stop) {
  const tables::Time turn = manager_.watchdog() == 0 ? kTurn : std::min(kTurn, manager_.watchdog() / 4);
  Clock::time_point next_line = Clock::now();
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    report_manager();
    report_links();
    report_waits();
    const bool due = draws_ && Clock::now() >= next_line;
    if (due) next_line += kLinePeriod;
    report_user(due);
    wake_.wait_for(lock, stop, std::chrono::nanoseconds(turn), [] { return false; });
  }
}

void Attendant::report_ready() {
  if (!ready_ && meter_.beats.value() != 0) ready_ = manager_.report("READY=1\nSTATUS=running");
}

void Attendant::report_manager() {
  if (!manager_.listens()) return;
  report_ready();
  if (!stopping_ && stop_requested().load()) stopping_ = manager_.report("STOPPING=1");
  const std::uint64_t beats = meter_.beats.value();
  if (manager_.watchdog() != 0 && beats != beats_ && manager_.report("WATCHDOG=1")) beats_ = beats;
}

void Attendant::report_links() {
  for (std::size_t i = 0; i < reporting_.size(); ++i) {
    for (const std::string& message : reporting_[i]->take_messages())
      console_.message(links_[i] + ": " + message + "\n");
  }
}

void Attendant::report_waits() {
  if (meter_.beats.value() == 0) return;  // the first cycle has not read the states of the links
  const std::chrono::nanoseconds now = Clock::now() - begin_;
  for (const std::string& line : waits_.look(now.count(), meter_)) console_.message(line);
}

void Attendant::report_user(bool line_is_due) {
  if (!console_.is_taken()) return;  // a blocked console would stop the watchdog messages
  const bool asked = take_status_request();
  if (!asked && !line_is_due) return;
  const std::string text = status_text(meter_, links_, degraded_);
  if (asked) console_.line(text + "\n");
  if (line_is_due) console_.draw(text.substr(0, terminal_width()));
}

}  // namespace symplant::host
