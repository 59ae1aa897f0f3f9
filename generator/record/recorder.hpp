// Records a PLC: one thread reads, another one writes.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "record/reader.hpp"
#include "record/writer.hpp"

namespace symplant::record {

/// Runs from its construction to stop(). The reading thread never waits for a disk: it puts changes into a queue, which
/// the writing thread empties every 20 ms. An image for which the queue has no room is lost, which becomes a gap.
class Recorder final {
 public:
  /// Parts, tables and writer must outlive it. Throws std::system_error if there is no thread left.
  Recorder(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every, Writer& writer);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() { stop(); }

  /// Ends the recording, and writes its last lines.
  void stop();

  /// Whether the writer needs no more images. Any thread, as the other members.
  bool has_ended() const noexcept { return ended_.load(std::memory_order_acquire); }
  RecordState state() const;
  std::vector<std::string> take_messages();
  const link::record::LoopMeter& meter() const { return reader_.meter(); }

 private:
  void write_on(const std::stop_token& stop);
  void write_queue();

  Writer& writer_;
  Reader reader_;
  mutable std::mutex mutex_;
  RecordState state_;  ///< this and the following are used under the mutex
  std::vector<std::string> messages_;
  std::atomic<bool> ended_{false};
  std::jthread writing_;  // the last member: it uses the others
};

}  // namespace symplant::record
