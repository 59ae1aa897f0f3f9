// Reads a PLC at a fixed interval.
#include "symplant/link/record/read_loop.hpp"

#include <algorithm>
#include <utility>

#include "symplant/link/client/reconnection.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::record {

using client::Fault;

namespace {

/// A gap in a recording is to be short.
constexpr tables::Time kLongestPause = 5 * tables::kSecond;

client::ClientTimes times_of(client::ClientTimes times) {
  times.last_retry = std::min(times.last_retry, kLongestPause);
  return times;
}

}  // namespace

ReadLoop::ReadLoop(client::ClientParts& parts, const tables::PlantTables& tables, tables::Time every, LoopClock& clock,
                   ImageSink& sink, LoopMeter& meter)
    : dialog_(*parts.dialog),
      tables_(tables),
      times_(times_of(parts.times)),
      every_(every),
      clock_(clock),
      sink_(sink),
      meter_(meter),
      reader_(*parts.dialog, tables, parts.map),
      needed_(parts.map.points.size()) {}

void ReadLoop::run() {
  client::Reconnection reconnection(times_);
  for (bool goes_on = true; goes_on;) {
    const tables::Time begin = clock_.now();
    passed_ = false;
    Fault fault = dialog_.open();
    if (!fault) {
      fault = talk();
      dialog_.close();
    }
    if (fault.kind == Fault::Kind::interrupted) return;
    if (passed_) {
      sink_.lost();
      identity_.clear();
    }
    if (passed_ || fault.message != last_fault_) sink_.message(fault.message);
    last_fault_ = std::move(fault.message);
    const tables::Time now = clock_.now();
    const tables::Time pause = passed_ ? reconnection.after_exchange(now - begin) : reconnection.after_failure();
    goes_on = clock_.sleep_until(now + pause);
  }
}

/// Reads over one connection until it fails.
Fault ReadLoop::talk() {
  Fault fault;
  const client::Identity identity = dialog_.identify(fault);
  if (fault) return fault;
  if (identity.message != std::exchange(identity_, identity.message)) {
    sink_.message((identity.kind == client::Identity::Kind::wrong ? "warning: " : "connected: ") + identity.message);
  }
  dialog_.retry_rejected();
  incomplete_since_ = -1;
  tables::Time due = clock_.now();
  tables::Time before = -1;  // when the latest complete image was read
  for (;;) {
    const tables::Time now = clock_.now();
    fault = reader_.read(now);
    report_rejections();
    if (fault) return fault;
    if (is_complete(now)) {
      if (before >= 0) meter_.intervals.add(reader_.first_sent() - before);
      before = reader_.first_sent();
      meter_.images.add(1);
      sink_.image({reader_.readings(), !std::exchange(passed_, true)});
    }
    due += every_;
    const tables::Time after = clock_.now();
    if (after > due) {
      meter_.late.add(1);
      due += (after - due) / every_ * every_;  // the latest time of the grid: this image begins at once
    }
    if (!clock_.sleep_until(due)) return {Fault::Kind::interrupted};
  }
}

/// Whether the latest reading has all symbols that the PLC does not refuse permanently.
bool ReadLoop::is_complete(tables::Time now) {
  const auto readings = reader_.readings();
  std::vector<bool> missing(readings.size());
  bool any_missing = false;
  bool any_read = readings.empty();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    any_read = any_read || readings[i].is_read;
    missing[i] = !readings[i].is_read && (needed_[i] || !any_needed_);
    any_missing = any_missing || missing[i];
  }
  if (any_missing) {
    if (incomplete_since_ < 0) incomplete_since_ = now;
    // The PLC may refuse a request and accept its parts, which takes some readings.
    const bool is_early = dialog_.is_dividing() || (any_needed_ && now - incomplete_since_ < kPatience);
    if (!any_read || is_early) {
      meter_.incomplete.add(1);
      return false;
    }
    sink_.message("warning: not readable, left out: " + names_of(missing));
  }
  incomplete_since_ = -1;
  any_needed_ = true;
  for (std::size_t i = 0; i < readings.size(); ++i) needed_[i] = readings[i].is_read;
  return true;
}

/// What the PLC refuses, for the user.
void ReadLoop::report_rejections() {
  for (client::Rejection& rejection : dialog_.take_rejections()) {
    if (rejection.answer != client::Answer::busy) sink_.message(std::move(rejection.message));
  }
  dialog_.take_left_out();
}

/// "`A`, `B`, `C` and 4 more".
std::string ReadLoop::names_of(const std::vector<bool>& chosen) const {
  constexpr std::size_t kNamed = 3;
  const auto texts = tables::split_names(tables_.symbol_names);
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i] || ++count > kNamed) continue;
    text.append(count == 1 ? "`" : ", `").append(texts[std::size_t{2} * reader_.readings()[i].symbol]).append("`");
  }
  return count > kNamed ? text + " and " + std::to_string(count - kNamed) + " more" : text;
}

}  // namespace symplant::link::record
