// Finds the events that came and went between two reads of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "symplant/link/image/event_reads.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::image {

/// Used by the cycle's thread. An event that no client reads again and again is never missed. Costs follow the changes.
class MissedEvents {
 public:
  MissedEvents(const Map& map, EventReads& reads);

  /// The next event with a missed value: a value that ended with the last image and that no client read, after a read
  /// of the other value. Nothing if there is no more. A read that is still in progress counts as a read of every value.
  /// O(events changed in the last cycle) for all calls.
  std::optional<LinkFinding> take() noexcept;

  // The next image, in this order.

  void begin_image(tables::Time now) noexcept;
  /// The value of a position differs from that in the image before.
  void changed(std::uint32_t position, bool on) noexcept;
  /// A position had both values since the image before, and now has the value `on`, changed or not.
  void pulsed(std::uint32_t position, bool on) noexcept;
  /// The image is published.
  void end_image() noexcept { requests_ = reads_.begun(); }

 private:
  /// A value that ended with the last image.
  struct Ended {
    std::uint32_t position;
    bool on;
    bool in_image;        ///< the value was in an image; false: it began and ended between two images
    tables::Time length;  ///< 0: less than a cycle
  };

  /// The value that clients have read last, among the values of a position that have ended.
  enum class Known : std::uint8_t { off, on, nothing };

  bool is_missed(const Ended& ended) noexcept;
  void add(const Ended& ended) noexcept {
    if (ended_.size() < ended_.capacity()) ended_.push_back(ended);
  }

  EventReads& reads_;
  std::vector<std::uint32_t> symbols_;  ///< by position: the first symbol; tables::kNone
  std::vector<tables::Time> begun_;     ///< by position: since when it has its value
  std::vector<Known> known_;            ///< by position
  std::vector<Ended> ended_;            ///< a position is here at most twice
  std::size_t next_ = 0;                ///< of ended_: to be examined next
  std::uint64_t requests_ = 0;          ///< begun when the last image was published
  tables::Time now_ = 0;
};

}  // namespace symplant::link::image
