// Reads a PLC on a thread that waits for nothing else.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "record/line.hpp"
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

/// What was read, until it is taken. One thread puts, another one takes.
class ImageQueue final : public link::record::ImageSink {
 public:
  static constexpr std::size_t kMost = 1'000'000;  ///< changes; an image counts as two more. 24 MB
  static constexpr std::size_t kMostMessages = 1'000;

  struct Taken {
    std::vector<Batch> batches;
    std::vector<std::string> messages;  ///< for the user
    bool is_lost = false;               ///< the connection, after all images
  };

  /// `readings`: of an image.
  explicit ImageQueue(std::size_t readings, std::size_t most = kMost) : changes_(readings), most_(most) {}

  /// An image for which there is no room is dropped: the next one has `after_loss`, and what both changed.
  void image(const link::record::Image& image) override;
  void lost() override;
  void message(std::string text) override;

  Taken take();

 private:
  static std::size_t size_of(const Batch& batch) { return batch.lines.size() + 2; }

  Changes changes_;  ///< of the thread that puts
  const std::size_t most_;
  bool after_loss_ = false;  ///< the next image, whatever it says itself; of the thread that puts
  std::mutex mutex_;
  Taken waiting_;
  std::size_t size_ = 0;
};

/// Reads from its construction to stop().
class Reader {
 public:
  /// Parts and tables must outlive it. Throws std::system_error if there is no thread left.
  Reader(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { stop(); }

  /// Ends a request that waits for its answer.
  void stop();
  /// What came since the last call. Any thread.
  ImageQueue::Taken take() { return queue_.take(); }
  const link::record::LoopMeter& meter() const { return meter_; }

 private:
  /// The steady clock, until reading ends.
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

  link::client::Dialog& dialog_;
  Clock clock_;
  link::record::LoopMeter meter_;
  ImageQueue queue_;
  link::record::ReadLoop loop_;
  std::jthread reading_;  // the last member: it uses the others
};

}  // namespace symplant::record
