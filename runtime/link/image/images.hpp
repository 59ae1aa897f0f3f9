// The images of a link's operations and events, shared by the cycle and the link's thread without a lock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "symplant/link/image/map.hpp"
#include "symplant/link/image/request_watch.hpp"
#include "symplant/link/image/status.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link::image {

/// The words of the planes. Bit p of a plane of bits is bit p % 64 of word p / 64. Number p is word p, as number_of()
/// makes it; where a protocol has words of 16 bits, lane 4 p + k (get_lane()) has bits 16 k to 16 k + 15 of it.
struct Planes {
  std::span<std::uint64_t> operation_bits;
  std::span<const std::uint64_t> event_bits;
  std::span<std::uint64_t> operation_numbers;
  std::span<const std::uint64_t> event_numbers;
};

/// Operations go from the link to the cycle, events back; a whole image at a time in each direction. At the start
/// operations are off and numbers have their initial values.
class Images {
 public:
  /// `watch`, if it is not null, gets all changes of events and must outlive this.
  Images(const tables::PlantTables& tables, const Map& map, RequestWatch* watch = nullptr);

  // --- the cycle's thread

  /// Applies the operations that changed since the last call to the plant. O(image) if there is a newer image, else
  /// O(1).
  void read_operations(plant::Plant& plant) noexcept;
  /// Publishes the plant's changed events (all of them at the first call) and the status. `now`: for the watch.
  void write_events(const plant::Plant& plant, const Status& status = {}, tables::Time now = 0) noexcept;

  // The parts of read_operations(), for a link that may be lost.

  /// Takes the latest image of the link, without applying it to the plant. O(1).
  void take_operations() noexcept;
  /// Whether, in the taken image, everything is written again that was written before loss number `losses`.
  bool is_complete(std::uint32_t losses) const noexcept;
  void apply_operations(plant::Plant& plant) noexcept;
  /// Sets those operations to zero whose policy on loss is zero. The next apply_operations() applies the image again.
  /// O(image).
  void zero_operations(plant::Plant& plant) noexcept;
  /// Publishes only the status.
  void write_status(const Status& status) noexcept;

  // --- the link's thread

  /// Takes the events of the latest cycle. O(1).
  void take_events() noexcept { events_.update(); }
  /// The events taken last, and the operations to change.
  Planes planes() noexcept;
  /// Marks positions of operations as written, for publish(). O(words).
  void touch(Plane plane, std::uint32_t first, std::uint32_t count) noexcept;
  /// Marks all operations as written. O(image).
  void touch_all() noexcept;
  /// Publishes the operations. `complete`: everything is written again that was written before the last loss. O(words
  /// touched).
  void publish(bool complete) noexcept;
  /// The number of the image that publish() publishes next; they count from 1.
  std::uint64_t next_image() const noexcept { return image_ + 1; }
  /// To be called before the operations are changed, with the number of losses so far. True after a loss: operations
  /// that went to zero are zero in the image, too, so that they stay zero until the PLC writes them again, and
  /// publish() must follow. O(1); O(image) after a loss.
  bool release(std::uint32_t losses) noexcept;

 private:
  /// Operations by position: those of position p are rows[first[p]] up to rows[first[p + 1]], without the latter.
  struct ByPosition {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> rows;  ///< symbols

    std::span<const std::uint32_t> at(std::uint32_t position) const noexcept;
  };

  static ByPosition by_position(const Map& map, Plane plane);
  std::vector<std::uint64_t> initial_operations(const Map& map) const;
  std::vector<std::uint64_t> zero_masks(const Map& map) const;
  std::uint64_t released(std::size_t word, std::uint64_t bits) const noexcept;
  void change_operations(plant::Plant& plant, std::span<const std::uint64_t> image) noexcept;
  void apply_bits(plant::Plant& plant, std::size_t word, std::uint64_t now, std::uint64_t changed) const noexcept;
  void apply_number(plant::Plant& plant, std::uint32_t position, std::uint64_t number) const noexcept;
  void write_event_word(std::uint32_t word, std::uint64_t bits) noexcept;
  void watch_pulses(std::uint32_t word, std::uint64_t pulsed) noexcept;
  void write_event_number(std::uint32_t slot, std::uint64_t value) noexcept;

  const tables::PlantTables& tables_;
  std::size_t operation_words_;  ///< of bits; numbers follow them
  std::size_t event_words_;      ///< of bits; numbers follow them
  ByPosition bits_;
  ByPosition numbers_;
  std::vector<std::uint64_t> applied_;  ///< the operations of the plant, as in the image
  std::vector<std::uint64_t> initial_;  ///< as before the first write
  std::vector<std::uint64_t> zeroed_;   ///< bits that go to zero when the link is lost
  std::vector<std::uint64_t> scratch_;  ///< memory of zero_operations()
  std::optional<std::uint32_t> status_;
  std::vector<std::uint64_t> events_written_;     ///< event bits of the plant, as in the image
  std::vector<std::uint32_t> position_of_event_;  ///< by event bit; tables::kNone
  std::vector<std::uint32_t> position_of_slot_;   ///< by slot of a numeric event; tables::kNone
  std::vector<tables::DataType> type_of_slot_;    ///< by slot of a numeric event
  bool first_write_ = true;
  bool behind_ = false;  ///< the taken image may differ from the operations of the plant
  std::uint32_t losses_seen_ = 0;
  std::uint64_t image_ = 0;        ///< number of the published image of operations
  RequestWatch* watch_;            ///< null: none
  share::SharedWords operations_;  ///< link -> cycle: the planes, the losses seen, whether all is rewritten, image_
  share::SharedWords events_;      ///< cycle -> link
};

}  // namespace symplant::link::image
