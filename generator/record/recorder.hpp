// Records a PLC: one thread reads, another one writes.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "record/line.hpp"
#include "record/writer.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/record/read_loop.hpp"

namespace symplant::record {

/// Finds what changed from image to image. Not thread-safe.
class Changes {
 public:
  explicit Changes(std::size_t readings) : values_(readings), known_(readings) {}

  /// What is new since the latest image that was accepted.
  Batch of(const link::record::Image& image) const;
  void accept(const link::record::Image& image);

 private:
  std::vector<std::uint64_t> values_;
  std::vector<bool> known_;
};

/// Runs from its construction to stop(). The reading thread never waits for a disk: it puts changes into a queue, which
/// the writing thread empties every 20 ms. An image for which the queue has no room is lost, which becomes a gap.
class Recorder final : private link::record::ImageSink {
 public:
  static constexpr std::size_t kMostQueued = 1'000'000;  ///< changes, 24 MB

  /// Parts, tables and writer must outlive it. Throws std::system_error if there is no thread left.
  Recorder(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every, Writer& writer);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() override { stop(); }

  /// Ends the recording, and writes its last lines.
  void stop();

  /// Whether the writer needs no more images. Any thread, as the other members.
  bool has_ended() const noexcept { return ended_.load(std::memory_order_acquire); }
  RecordState state() const;
  std::vector<std::string> take_messages();
  const link::record::LoopMeter& meter() const { return meter_; }

 private:
  /// The steady clock, until the recording ends.
  class Clock final : public link::record::LoopClock {
   public:
    Time now() override;
    bool sleep_until(Time time) override;
    void stop();

   private:
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stopped_ = false;
  };

  void image(const link::record::Image& image) override;
  void lost() override;
  void message(std::string text) override;
  void write_on(const std::stop_token& stop);
  void write_queue();

  link::client::Dialog& dialog_;
  Writer& writer_;
  Clock clock_;
  link::record::LoopMeter meter_;
  Changes changes_;  ///< of the reading thread
  link::record::ReadLoop loop_;
  mutable std::mutex mutex_;
  std::vector<Batch> queue_;  ///< this and the following are used under the mutex
  std::size_t queued_ = 0;    ///< lines
  bool is_lost_ = false;
  RecordState state_;
  std::vector<std::string> messages_;
  std::atomic<bool> ended_{false};
  std::jthread writing_;  // last members: they use the others
  std::jthread reading_;
};

}  // namespace symplant::record
