// Reads a PLC at a fixed interval, and connects again after each failure; writes nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "symplant/exec/histogram.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/record/image_reader.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::record {

/// The steady clock of a loop, in ns; tests replace it.
class LoopClock {
 public:
  LoopClock() = default;
  LoopClock(const LoopClock&) = delete;
  LoopClock& operator=(const LoopClock&) = delete;
  virtual ~LoopClock() = default;

  virtual tables::Time now() = 0;
  /// Sleeps until `time`, or returns at once if it is over. False: the loop is to end.
  virtual bool sleep_until(tables::Time time) = 0;
};

/// All symbols of the PLC, once.
struct Image {
  std::span<const Reading> readings;  ///< those that are not `is_read` have their values of an earlier image
  bool reconnected = false;           ///< the first one over a new connection
};

/// Gets what a loop reads, on the loop's thread.
class ImageSink {
 public:
  ImageSink() = default;
  ImageSink(const ImageSink&) = delete;
  ImageSink& operator=(const ImageSink&) = delete;
  virtual ~ImageSink() = default;

  virtual void image(const Image& image) = 0;
  /// The connection is lost: what follows is an image with `reconnected`, or nothing.
  virtual void lost() = 0;
  /// For the user.
  virtual void message(std::string text) = 0;
};

/// How well a loop keeps its interval. The loop counts, any thread reads.
struct LoopMeter {
  exec::Histogram intervals;  ///< from one image to the next over the same connection
  exec::Counter images;
  exec::Counter late;        ///< images that began late, since the one before took longer than the interval
  exec::Counter incomplete;  ///< readings that the PLC refused in part; they are not used
};

/// Images begin on a fixed grid of `every`. After one that took longer, the next begins at once. An image of which the
/// PLC refuses a part is not used; after kPatience the symbols of this part are reported and left out, until the PLC
/// accepts them again. Ends when the clock says so.
class ReadLoop {
 public:
  static constexpr tables::Time kPatience = 5 * tables::kSecond;

  /// The arguments must outlive it.
  ReadLoop(client::ClientParts& parts, const tables::PlantTables& tables, tables::Time every, LoopClock& clock,
           ImageSink& sink, LoopMeter& meter);

  void run();

 private:
  client::Fault talk();
  bool is_complete(tables::Time now);
  void report_rejections();
  std::string names_of(const std::vector<bool>& chosen) const;

  client::Dialog& dialog_;
  const tables::PlantTables& tables_;
  const client::ClientTimes times_;
  const tables::Time every_;
  LoopClock& clock_;
  ImageSink& sink_;
  LoopMeter& meter_;
  ImageReader reader_;
  std::vector<bool> needed_;            ///< by reading: an image is complete only with it
  bool any_needed_ = false;             ///< there was a complete image
  tables::Time incomplete_since_ = -1;  ///< -1: the latest reading was complete
  bool passed_ = false;                 ///< this connection has brought a complete image
  std::string identity_;                ///< as reported last, since the connection brought an image
  std::string last_fault_;              ///< a lasting one is reported once
};

}  // namespace symplant::link::record
