// The thread of a client link.
#include "symplant/link/client/poller.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/link/net/no_signals.hpp"

namespace symplant::link::client {

namespace {

tables::Time steady_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Whether both name a common bit of the same lane.
bool meet(const LaneChange& one, const LaneChange& other) {
  return one.lane == other.lane && (one.mask & other.mask) != 0;
}

/// Whether the point lies in a bit of the change.
bool covers(const LaneChange& change, const IoPoint& point) {
  if (change.lane.table != point.table) return false;
  if (point.table == Table::input_register) {
    return point.number <= change.lane.number && change.lane.number <= point.last();
  }
  return point.number / 16 == change.lane.number && (change.mask >> (point.number % 16) & 1) != 0;
}

}  // namespace

Poller::Poller(ClientParts parts, image::Images& images, bool arm, std::string note)
    : dialog_(std::move(parts.dialog)),
      images_(images),
      points_(parts.map.points),
      times_(parts.times),
      arm_(arm),
      outbox_(parts.map),
      discrete_inputs_(image::bit_words(parts.map.sizes[static_cast<std::size_t>(Table::discrete_input)])),
      input_registers_(image::register_words(parts.map.sizes[static_cast<std::size_t>(Table::input_register)])),
      reported_(points_.size()) {
  messages_.add(std::move(note));
  zeros_.resize(std::max(discrete_inputs_.size(), input_registers_.size()));
  const net::NoSignals blocked;
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Poller::~Poller() {
  thread_.request_stop();
  dialog_->interrupt();
  thread_.join();
}

LinkStatus Poller::status() const noexcept {
  LinkStatus status;
  status.requests = dialog_->requests();
  status.exceptions = dialog_->rejected();
  status.connections = connections_.load(std::memory_order_relaxed);
  status.losses = losses_.load(std::memory_order_relaxed);
  status.is_client = true;
  status.reached = reached_.load(std::memory_order_relaxed);
  status.armed = armed_.load(std::memory_order_relaxed);
  status.end_unread = status.armed && status.connections != 0 && leaving_.load(std::memory_order_relaxed) &&
                      !left_.load(std::memory_order_relaxed);
  return status;
}

/// False if the thread is to end.
bool Poller::sleep(const std::stop_token& stop, tables::Time duration) {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, stop, std::chrono::nanoseconds(duration), [] { return false; });
  return !stop.stop_requested();
}

void Poller::run(const std::stop_token& stop) {
  tables::Time retry = times_.first_retry;
  while (!stop.stop_requested()) {
    if (cut_.load(std::memory_order_relaxed)) {
      if (!sleep(stop, std::max(times_.poll, tables::kMillisecond))) return;
      continue;
    }
    Fault fault = dialog_->open();
    const bool opened = !fault;
    if (opened) {
      passed_ = false;
      connections_.store(1, std::memory_order_relaxed);
      reached_.store(true, std::memory_order_relaxed);
      fault = talk(stop);
      connections_.store(0, std::memory_order_relaxed);
      dialog_->close();
      retry = times_.first_retry;
    }
    if (stop.stop_requested()) return;
    messages_.add(std::move(fault.message));
    if (opened && passed_) {
      messages_.forget();  // this was a working connection: what comes next is news
      continue;
    }
    if (!sleep(stop, retry)) return;
    if (!opened) retry = std::min(2 * retry, times_.last_retry);
  }
}

bool Poller::may_write(const Identity& identity) {
  switch (identity.kind) {
    case Identity::Kind::verified:
      messages_.add("connected: " + identity.message);
      return true;
    case Identity::Kind::wrong:
      messages_.add("writes nothing: " + identity.message);
      return false;
    case Identity::Kind::unverifiable:
      break;
  }
  messages_.add(arm_ ? "connected, armed: " + identity.message
                     : "not armed, writes nothing: " + identity.message +
                           "; check the address and the map, then give `--arm`");
  return arm_;
}

Fault Poller::talk(const std::stop_token& stop) {
  Fault fault;
  const Identity identity = dialog_->identify(fault);
  if (fault) return fault;
  const bool writes = may_write(identity);
  armed_.store(writes, std::memory_order_relaxed);
  dialog_->retry_rejected();
  outbox_.forget();
  suspects_.clear();
  next_refresh_ = steady_now() + times_.refresh;
  next_look_back_ = steady_now() + times_.read_back;
  for (;;) {
    if (cut_.load(std::memory_order_relaxed)) return {Fault::Kind::interrupted, "cut by a malfunction"};
    const tables::Time begin = steady_now();
    fault = pass(writes);
    for (std::string& message : dialog_->take_rejections()) messages_.add(std::move(message));
    if (fault) return fault;
    const tables::Time spent = steady_now() - begin;
    if (!sleep(stop, std::max<tables::Time>(times_.poll - spent, 0))) return {Fault::Kind::interrupted};
  }
}

/// Reads all, then writes what changed. A fault ends the connection.
Fault Poller::pass(bool writes) {
  const bool leaving = leaving_.load(std::memory_order_acquire);  // before the events are taken
  if (steady_now() >= next_refresh_) {
    next_refresh_ += times_.refresh;
    outbox_.forget();
    dialog_->retry_rejected();
  }
  images_.begin_request(losses_.load(std::memory_order_relaxed));
  image::Tables tables = images_.tables();
  Fault fault = dialog_->read(tables);
  if (fault.kind == Fault::Kind::rejected) return {};
  if (fault) return fault;
  passed_ = true;
  images_.written_all();
  signs_.fetch_add(1, std::memory_order_release);  // after the image, so that a cycle that sees it has the image
  if (!writes) return {};
  if (leaving && times_.zero_at_end) {
    tables.discrete_inputs.words = std::span(zeros_).first(discrete_inputs_.size());
    tables.input_registers.words = std::span(zeros_).first(input_registers_.size());
  }
  if (times_.read_back != 0 && steady_now() >= next_look_back_) fault = look_back();
  if (!fault) fault = write(tables);
  if (!fault && leaving) left_.store(true, std::memory_order_relaxed);
  return fault;
}

Fault Poller::write(const image::Tables& tables) {
  const auto changes = outbox_.changes(tables);
  if (changes.empty()) return {};
  Fault fault = dialog_->write(changes);
  if (!fault) outbox_.confirm(changes);
  return fault;
}

/// Reads the events back. Those that differ are written again, those that differ twice in a row are reported.
Fault Poller::look_back() {
  next_look_back_ += times_.read_back;
  Fault fault = dialog_->read_back(discrete_inputs_, input_registers_);
  if (fault.kind == Fault::Kind::rejected) return {};
  if (fault) return fault;
  std::vector<LaneChange> now = outbox_.differences(discrete_inputs_, input_registers_);
  std::vector<LaneChange> twice;
  for (const LaneChange& change : now) {
    for (const LaneChange& before : suspects_) {
      if (meet(change, before)) {
        twice.push_back({change.lane, static_cast<std::uint16_t>(change.mask & before.mask), change.value});
      }
    }
  }
  suspects_ = std::move(now);
  note_overwritten(twice);
  offer_overwritten();
  outbox_.forget(suspects_);
  return {};
}

void Poller::note_overwritten(const std::vector<LaneChange>& lanes) {
  for (const LaneChange& change : lanes) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (reported_[i] || !covers(change, points_[i])) continue;
      reported_[i] = true;
      to_report_.push_back(points_[i].symbol);
    }
  }
}

void Poller::offer_overwritten() noexcept {
  if (to_report_.empty()) return;
  std::uint32_t none = tables::kNone;
  if (overwritten_.compare_exchange_strong(none, to_report_.back(), std::memory_order_release)) to_report_.pop_back();
}

}  // namespace symplant::link::client
