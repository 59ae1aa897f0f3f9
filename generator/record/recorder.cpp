// Records a PLC: one thread reads, another one writes.
#include "record/recorder.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/net/no_signals.hpp"

namespace symplant::record {
namespace {

using link::record::Reading;

/// With the interval of readings and the time of a request it is below the 100 ms that a killed process may lose.
constexpr auto kWriteEvery = std::chrono::milliseconds(20);

}  // namespace

Batch Changes::of(const link::record::Image& image) const {
  Batch batch;
  batch.reconnected = image.reconnected;
  bool any = false;
  for (std::size_t i = 0; i < image.readings.size(); ++i) {
    const Reading& reading = image.readings[i];
    if (!reading.is_read) continue;
    batch.first = any ? std::min(batch.first, reading.time) : reading.time;
    batch.last = std::max(batch.last, reading.time);
    any = true;
    if (!known_[i] || values_[i] != reading.value) batch.lines.push_back({reading.time, reading.value, reading.symbol});
  }
  std::stable_sort(batch.lines.begin(), batch.lines.end(),
                   [](const Line& a, const Line& b) { return a.time < b.time; });
  return batch;
}

void Changes::accept(const link::record::Image& image) {
  for (std::size_t i = 0; i < image.readings.size(); ++i) {
    if (!image.readings[i].is_read) continue;
    values_[i] = image.readings[i].value;
    known_[i] = true;
  }
}

Time Recorder::Clock::now() { return link::client::steady_now(); }

bool Recorder::Clock::sleep_until(Time time) {
  std::unique_lock lock(mutex_);
  const std::chrono::steady_clock::time_point until{std::chrono::nanoseconds(time)};
  wake_.wait_until(lock, until, [this] { return stopped_; });
  return !stopped_;
}

void Recorder::Clock::stop() {
  const std::scoped_lock lock(mutex_);
  stopped_ = true;
  wake_.notify_all();
}

Recorder::Recorder(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every, Writer& writer)
    : dialog_(*parts.dialog),
      writer_(writer),
      changes_(parts.map.points.size()),
      loop_(parts, tables, every, clock_, *this, meter_) {
  const link::net::NoSignals blocked;
  writing_ = std::jthread([this](const std::stop_token& stop) { write_on(stop); });
  reading_ = std::jthread([this] { loop_.run(); });
}

void Recorder::stop() {
  if (!reading_.joinable()) return;
  clock_.stop();
  dialog_.interrupt();
  reading_.join();
  writing_.request_stop();
  writing_.join();
  write_queue();
  writer_.finish(clock_.now());
  const std::scoped_lock lock(mutex_);
  state_ = writer_.state();
}

void Recorder::image(const link::record::Image& image) {
  Batch batch = changes_.of(image);
  const std::scoped_lock lock(mutex_);
  if (queued_ + batch.lines.size() > kMostQueued) return;
  queued_ += batch.lines.size();
  is_lost_ = false;
  queue_.push_back(std::move(batch));
  changes_.accept(image);
}

void Recorder::lost() {
  const std::scoped_lock lock(mutex_);
  is_lost_ = true;
}

void Recorder::message(std::string text) {
  const std::scoped_lock lock(mutex_);
  messages_.push_back(std::move(text));
}

void Recorder::write_on(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    write_queue();
    std::this_thread::sleep_for(kWriteEvery);
  }
}

void Recorder::write_queue() {
  std::vector<Batch> batches;
  bool is_lost = false;
  {
    const std::scoped_lock lock(mutex_);
    batches.swap(queue_);
    queued_ = 0;
    is_lost = is_lost_;
  }
  for (const Batch& batch : batches) writer_.take(batch);
  if (is_lost) writer_.lost();
  writer_.look(clock_.now());
  writer_.flush();
  if (writer_.has_ended()) ended_.store(true, std::memory_order_release);
  std::string text = writer_.take_message();
  const std::scoped_lock lock(mutex_);
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
