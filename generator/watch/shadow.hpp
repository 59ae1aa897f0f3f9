// Lets a watcher follow what is read of a plant, from a recording or a link.
#pragma once

#include <vector>

#include "observe/play.hpp"
#include "recording/recording.hpp"
#include "watch/watcher.hpp"

namespace symplant::watch {

/// Takes what is read, image by image. Not thread-safe.
class Shadow {
 public:
  /// As Watcher.
  Shadow(const model::PlantModel& plant, const std::vector<bool>& recorded, const Margin& margin,
         const std::vector<Statistic>& learned, Watcher::Report report);

  /// Sets a symbol to a value from the time of the next close() on. O(1).
  void set(std::uint32_t symbol, double value) { changes_.push_back({symbol, value}); }
  /// Ends an image: all changes since the last one happened at `time`, which must not decrease.
  void close(Time time);
  /// Nothing was read for `length` from `begin` on. What follows is as at the beginning.
  void gap(Time begin, Time length);
  /// After the last image.
  void finish(Time end) { watcher_.finish(end); }

  const Counts& counts() const { return watcher_.counts(); }

 private:
  struct Change {
    std::uint32_t symbol;
    double value;
  };
  const model::PlantModel& plant_;
  observe::Observer observer_;
  Watcher watcher_;
  std::vector<Change> changes_;
};

/// Passes a whole recording on. O(changes * log units).
void follow(const recording::Recording& recording, const observe::Matched& matched, Shadow& shadow);

}  // namespace symplant::watch
