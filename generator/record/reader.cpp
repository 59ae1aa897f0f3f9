// Reads a PLC on a thread that waits for nothing else.
#include "record/reader.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/net/no_signals.hpp"

namespace symplant::record {

using link::record::Reading;

Batch Changes::of(const link::record::Image& image) const {
  Batch batch;
  batch.after_loss = image.reconnected;
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

void ImageQueue::image(const link::record::Image& image) {
  Batch batch = changes_.of(image);
  batch.after_loss = batch.after_loss || after_loss_;
  const std::scoped_lock lock(mutex_);
  after_loss_ = size_ + size_of(batch) > most_;
  if (after_loss_) return;
  size_ += size_of(batch);
  waiting_.is_lost = false;
  waiting_.batches.push_back(std::move(batch));
  changes_.accept(image);
}

void ImageQueue::lost() {
  const std::scoped_lock lock(mutex_);
  waiting_.is_lost = true;
}

void ImageQueue::message(std::string text) {
  const std::scoped_lock lock(mutex_);
  if (waiting_.messages.size() < kMostMessages) waiting_.messages.push_back(std::move(text));
}

ImageQueue::Taken ImageQueue::take() {
  const std::scoped_lock lock(mutex_);
  Taken taken = std::exchange(waiting_, {});
  waiting_.is_lost = taken.is_lost;
  size_ = 0;
  return taken;
}

Time Reader::Clock::now() { return link::client::steady_now(); }

bool Reader::Clock::sleep_until(Time time) {
  std::unique_lock lock(mutex_);
  const std::chrono::steady_clock::time_point until{std::chrono::nanoseconds(time)};
  wake_.wait_until(lock, until, [this] { return stopped_; });
  return !stopped_;
}

void Reader::Clock::stop() {
  const std::scoped_lock lock(mutex_);
  stopped_ = true;
  wake_.notify_all();
}

Reader::Reader(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every)
    : dialog_(*parts.dialog), queue_(parts.map.points.size()), loop_(parts, tables, every, clock_, queue_, meter_) {
  const link::net::NoSignals blocked;
  reading_ = std::jthread([this] { loop_.run(); });
}

void Reader::stop() {
  if (!reading_.joinable()) return;
  clock_.stop();
  dialog_.interrupt();
  reading_.join();
}

}  // namespace symplant::record
