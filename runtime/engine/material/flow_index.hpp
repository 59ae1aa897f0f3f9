// Look-ups for the material flow, built once from the tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/material/part.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

/// A position of a track at which something depends on being covered: a sensor, or where a transfer takes parts from,
/// which is the track's end if it gives no position.
struct Mark {
  Position at;
  std::uint32_t of;  ///< index of a sensor; or of a transfer, if `transfer`
  bool transfer;
};

/// Numbers by owner: those of owner i are contiguous.
class NumbersOf {
 public:
  /// `for_each(add)` calls `add(owner, number)` for every pair, the same ones in each of two calls.
  template <class ForEach>
  void build(std::size_t owners, Arena& arena, ForEach for_each) noexcept {
    auto* const begins = arena.take<std::uint32_t>(owners + 1);
    std::uint32_t size = 0;
    for_each([&](std::uint32_t owner, std::uint32_t) {
      ++size;
      if (begins != nullptr) ++begins[owner + 1];
    });
    auto* const numbers = arena.take<std::uint32_t>(size);
    begins_ = begins;
    numbers_ = numbers;
    if (begins == nullptr) return;
    for (std::size_t i = 0; i < owners; ++i) begins[i + 1] += begins[i];
    // Filling moves the begin of each owner to that of the next owner; the loop after it moves all begins back.
    for_each([&](std::uint32_t owner, std::uint32_t number) { numbers[begins[owner]++] = number; });
    for (std::size_t i = owners; i > 0; --i) begins[i] = begins[i - 1];
    begins[0] = 0;
  }
  std::span<const std::uint32_t> of(std::uint32_t owner) const noexcept {
    return {numbers_ + begins_[owner], numbers_ + begins_[owner + 1]};
  }

 private:
  const std::uint32_t* begins_ = nullptr;
  const std::uint32_t* numbers_ = nullptr;
};

/// What may bring parts to a location: an end, a transfer or a source.
enum class ArrivalBy : std::uint8_t { end, transfer, source };

struct TrackIndex {
  Position length;
  Position gap;
  const Mark* marks;  ///< sorted by position
  std::uint32_t mark_count;
  const tables::StopRow* stops;  ///< sorted by position
  std::uint32_t stop_count;
  std::uint32_t first_part;  ///< of its parts, in the array of all tracks' parts
  std::uint32_t capacity;    ///< the most parts that fit

  std::span<const tables::StopRow> sorted_stops() const noexcept { return {stops, stop_count}; }
};

/// A drive whose speed follows a numeric symbol.
struct SpeedReader {
  std::uint32_t position;  ///< an operation's slot, kEventSlot + an event's, or kOutputOfValue + an output
  std::uint32_t track;
};
inline constexpr std::uint32_t kEventSlot = 0x8000'0000;
inline constexpr std::uint32_t kOutputOfValue = 0x4000'0000;

struct FlowIndex {
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;

  const TrackIndex* tracks = nullptr;
  const Position* lengths = nullptr;              ///< of kinds
  const std::uint32_t* track_of_drive = nullptr;  ///< by row; so are the next two
  const std::uint32_t* track_of_stop = nullptr;
  const std::uint32_t* track_of_end = nullptr;
  NumbersOf ends_to;       ///< a location -> the tracks with an end that leads there
  NumbersOf transfers_to;  ///< a location -> transfers
  NumbersOf sources_to;
  NumbersOf transfers_from;
  NumbersOf counters_of;                       ///< a location -> the counters of its parts
  std::span<const SpeedReader> speed_readers;  ///< sorted by position
  std::uint32_t parts_on_tracks = 0;           ///< the sum of all capacities
  std::uint32_t parts_in_places = 0;
  const std::uint32_t* first_in_place = nullptr;  ///< of a place's parts, in the array of all places' parts

 private:
  void build_tracks(const tables::PlantTables& tables, Arena& arena) noexcept;
  void build_arrivals(const tables::MaterialTables& material, Arena& arena) noexcept;
  void build_speed_readers(const tables::PlantTables& tables, Arena& arena) noexcept;
};

}  // namespace symplant::engine
