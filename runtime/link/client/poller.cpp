// The thread of a client link.
#include "symplant/link/client/poller.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/link/client/reconnection.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/net/no_signals.hpp"

namespace symplant::link::client {

Poller::Poller(ClientParts parts, const tables::PlantTables& tables, image::Images& images, bool arm, std::string note)
    : dialog_(std::move(parts.dialog)),
      times_(parts.times),
      session_(*dialog_, tables, parts.map, parts.times, images, arm) {
  session_.messages().add(std::move(note));
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
  status.armed = session_.is_armed();
  status.end_unread =
      status.armed && status.connections != 0 && leaving_.load(std::memory_order_relaxed) && !session_.has_left();
  return status;
}

/// False if the thread is to end.
bool Poller::sleep(const std::stop_token& stop, tables::Time duration) {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, stop, std::chrono::nanoseconds(duration), [] { return false; });
  return !stop.stop_requested();
}

void Poller::run(const std::stop_token& stop) {
  Reconnection reconnection(times_);
  while (!stop.stop_requested()) {
    if (cut_.load(std::memory_order_relaxed)) {
      if (!sleep(stop, std::max(times_.poll, tables::kMillisecond))) return;
      continue;
    }
    const tables::Time begin = steady_now();
    Fault fault = dialog_->open();
    const bool opened = !fault;
    if (opened) {
      connections_.store(1, std::memory_order_relaxed);
      reached_.store(true, std::memory_order_relaxed);
      fault = talk(stop);
      connections_.store(0, std::memory_order_relaxed);
      dialog_->close();
    }
    if (stop.stop_requested()) return;
    session_.messages().add(std::move(fault.message));
    const bool exchanged = opened && session_.has_passed();
    const tables::Time pause =
        exchanged ? reconnection.after_exchange(steady_now() - begin) : reconnection.after_failure();
    if (exchanged && pause == 0) session_.messages().forget();  // it was a good connection: what comes next is news
    if (!sleep(stop, pause)) return;
  }
}

Fault Poller::talk(const std::stop_token& stop) {
  if (Fault fault = session_.begin(steady_now())) return fault;
  for (;;) {
    if (cut_.load(std::memory_order_relaxed)) return {Fault::Kind::interrupted, "cut by a malfunction"};
    const tables::Time begin = steady_now();
    const bool leaving = leaving_.load(std::memory_order_acquire);  // before the events are taken
    if (Fault fault = session_.pass(begin, losses_.load(std::memory_order_relaxed), leaving)) return fault;
    const tables::Time spent = steady_now() - begin;
    if (!sleep(stop, std::max<tables::Time>(times_.poll - spent, 0))) return {Fault::Kind::interrupted};
  }
}

}  // namespace symplant::link::client
