// Records a PLC: one thread reads, another one writes.
#include "record/recorder.hpp"

#include <chrono>
#include <iterator>
#include <utility>

#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/net/no_signals.hpp"

namespace symplant::record {
namespace {

/// With the interval of readings and the time of a request it is below the 100 ms that a killed process may lose.
constexpr auto kWriteEvery = std::chrono::milliseconds(20);

}  // namespace

Recorder::Recorder(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every, Writer& writer)
    : writer_(writer), reader_(parts, tables, every) {
  const link::net::NoSignals blocked;
  writing_ = std::jthread([this](const std::stop_token& stop) { write_on(stop); });
}

void Recorder::stop() {
  if (!writing_.joinable()) return;
  reader_.stop();
  writing_.request_stop();
  writing_.join();
  write_queue();
  writer_.finish(link::client::steady_now());
  const std::scoped_lock lock(mutex_);
  state_ = writer_.state();
}

void Recorder::write_on(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    write_queue();
    std::this_thread::sleep_for(kWriteEvery);
  }
}

void Recorder::write_queue() {
  ImageQueue::Taken taken = reader_.take();
  for (const Batch& batch : taken.batches) writer_.take(batch);
  if (taken.is_lost) writer_.lost();
  writer_.look(link::client::steady_now());
  writer_.flush();
  if (writer_.has_ended()) ended_.store(true, std::memory_order_release);
  std::string text = writer_.take_message();
  const std::scoped_lock lock(mutex_);
  messages_.insert(messages_.end(), std::make_move_iterator(taken.messages.begin()),
                   std::make_move_iterator(taken.messages.end()));
  if (!text.empty()) messages_.push_back(std::move(text));
  state_ = writer_.state();
}

RecordState Recorder::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

std::vector<std::string> Recorder::take_messages() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(messages_, {});
}

}  // namespace symplant::record
