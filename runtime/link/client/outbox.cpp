// What a PLC has confirmed of the events, and what has changed since.
#include "symplant/link/client/outbox.hpp"

#include <algorithm>
#include <cstddef>

#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::client {

namespace {

using image::kLanesPerWord;

std::uint16_t lane_of(std::uint64_t word, std::uint32_t k) { return static_cast<std::uint16_t>(word >> (16 * k)); }

/// Appends the lanes of word number `word` in which `differs` has a bit.
void add_lanes(std::vector<LaneChange>& lanes, Plane plane, std::size_t word, std::uint64_t differs,
               std::uint64_t value) {
  for (std::uint32_t k = 0; differs != 0 && k < kLanesPerWord; ++k) {
    const std::uint16_t mask = lane_of(differs, k);
    if (mask == 0) continue;
    lanes.push_back({{plane, static_cast<std::uint32_t>(word) * kLanesPerWord + k}, mask, lane_of(value, k)});
  }
}

}  // namespace

Outbox::Outbox(const tables::PlantTables& tables, const image::Map& map) {
  sides_[0].plane = Plane::event_bits;
  sides_[1].plane = Plane::event_numbers;
  for (Side& side : sides_) {
    const std::uint32_t size = map.size(side.plane);
    side.mapped.resize(has_bits(side.plane) ? image::bit_words(size) : size);
    side.confirmed.resize(side.mapped.size());
    side.known.resize(side.mapped.size());
    side.held.resize(side.mapped.size());
  }
  for (const EventLanes& event : event_lanes(tables, map)) {
    for (const LaneChange& change : event.lanes) {
      Side& side = side_of(change.lane);
      const std::uint32_t mapped = image::get_lane(side.mapped, change.lane.number) | change.mask;
      image::set_lane(side.mapped, change.lane.number, static_cast<std::uint16_t>(mapped));
    }
  }
}

void Outbox::forget() noexcept {
  for (Side& side : sides_) std::fill(side.known.begin(), side.known.end(), 0);
}

void Outbox::restart() noexcept {
  forget();
  for (Side& side : sides_) std::fill(side.held.begin(), side.held.end(), 0);
}

void Outbox::hold(std::span<const LaneChange> lanes) noexcept {
  for (const LaneChange& change : lanes) {
    Side& side = side_of(change.lane);
    const std::uint32_t held = image::get_lane(side.held, change.lane.number) | change.mask;
    image::set_lane(side.held, change.lane.number, static_cast<std::uint16_t>(held));
  }
}

void Outbox::release(std::span<const LaneChange> lanes) noexcept {
  for (const LaneChange& change : lanes) {
    Side& side = side_of(change.lane);
    const std::uint32_t held = image::get_lane(side.held, change.lane.number) & ~std::uint32_t{change.mask};
    image::set_lane(side.held, change.lane.number, static_cast<std::uint16_t>(held));
  }
}

Outbox::Side& Outbox::side_of(const Lane& lane) noexcept { return sides_[lane.plane == Plane::event_bits ? 0 : 1]; }

void Outbox::forget(std::span<const LaneChange> lanes) noexcept {
  for (const LaneChange& change : lanes) {
    Side& side = side_of(change.lane);
    const std::uint32_t known = image::get_lane(side.known, change.lane.number) & ~std::uint32_t{change.mask};
    image::set_lane(side.known, change.lane.number, static_cast<std::uint16_t>(known));
  }
}

std::span<const LaneChange> Outbox::changes(const Events& events) {
  changes_.clear();
  for (const Side& side : sides_) {
    const auto words = events.of(side.plane);
    for (std::size_t word = 0; word < side.mapped.size(); ++word) {
      const std::uint64_t free = side.mapped[word] & ~side.held[word];
      const std::uint64_t differs = free & ((words[word] ^ side.confirmed[word]) | ~side.known[word]);
      add_lanes(changes_, side.plane, word, differs, words[word]);
    }
  }
  return changes_;
}

void Outbox::confirm(std::span<const LaneChange> changes) noexcept {
  for (const LaneChange& change : changes) {
    Side& side = side_of(change.lane);
    const std::uint32_t lane = change.lane.number;
    const std::uint32_t kept = image::get_lane(side.confirmed, lane) & ~std::uint32_t{change.mask};
    image::set_lane(side.confirmed, lane, static_cast<std::uint16_t>(kept | (change.value & change.mask)));
    const std::uint32_t known = image::get_lane(side.known, lane) | change.mask;
    image::set_lane(side.known, lane, static_cast<std::uint16_t>(known));
  }
}

std::vector<LaneChange> Outbox::differences(const Events& read_back) const {
  std::vector<LaneChange> lanes;
  for (const Side& side : sides_) {
    const auto words = read_back.of(side.plane);
    for (std::size_t word = 0; word < side.mapped.size(); ++word) {
      add_lanes(lanes, side.plane, word, (words[word] ^ side.confirmed[word]) & side.known[word], words[word]);
    }
  }
  return lanes;
}

}  // namespace symplant::link::client
