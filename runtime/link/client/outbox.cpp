// What a PLC has confirmed of the events, and what has changed since.
#include "symplant/link/client/outbox.hpp"

#include <algorithm>
#include <cstddef>

namespace symplant::link::client {

namespace {

constexpr std::uint32_t kLanesPerWord = 4;

std::uint16_t lane_of(std::uint64_t word, std::uint32_t k) { return static_cast<std::uint16_t>(word >> (16 * k)); }

/// Appends the lanes of word number `word` in which `differs` has a bit.
void add_lanes(std::vector<LaneChange>& lanes, Table table, std::size_t word, std::uint64_t differs,
               std::uint64_t value) {
  for (std::uint32_t k = 0; differs != 0 && k < kLanesPerWord; ++k) {
    const std::uint16_t mask = lane_of(differs, k);
    if (mask == 0) continue;
    lanes.push_back({{table, static_cast<std::uint32_t>(word) * kLanesPerWord + k}, mask, lane_of(value, k)});
  }
}

}  // namespace

Outbox::Outbox(const IoMap& map) {
  sides_[0].table = Table::discrete_input;
  sides_[1].table = Table::input_register;
  for (Side& side : sides_) {
    const std::uint32_t size = map.sizes[static_cast<std::size_t>(side.table)];
    const bool bits = side.table == Table::discrete_input;
    side.mapped.resize(bits ? image::bit_words(size) : image::register_words(size));
    side.confirmed.resize(side.mapped.size());
    side.known.resize(side.mapped.size());
    side.held.resize(side.mapped.size());
    for (const IoPoint& point : map.points) {
      if (point.table != side.table) continue;
      if (bits) image::set_bit(side.mapped, point.number, true);
      for (std::uint32_t k = 0; !bits && k < point.width; ++k)
        image::set_register(side.mapped, point.number + k, 0xFFFF);
    }
  }
  if (!map.status_block) return;
  for (std::uint32_t k = 0; k < kStatusRegisters; ++k) {
    image::set_register(sides_[1].mapped, *map.status_block + k, 0xFFFF);
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
    const std::uint32_t held = image::get_register(side.held, change.lane.number) | change.mask;
    image::set_register(side.held, change.lane.number, static_cast<std::uint16_t>(held));
  }
}

void Outbox::release(std::span<const LaneChange> lanes) noexcept {
  for (const LaneChange& change : lanes) {
    Side& side = side_of(change.lane);
    const std::uint32_t held = image::get_register(side.held, change.lane.number) & ~std::uint32_t{change.mask};
    image::set_register(side.held, change.lane.number, static_cast<std::uint16_t>(held));
  }
}

Outbox::Side& Outbox::side_of(const Lane& lane) noexcept { return sides_[lane.table == Table::discrete_input ? 0 : 1]; }

void Outbox::forget(std::span<const LaneChange> lanes) noexcept {
  for (const LaneChange& change : lanes) {
    Side& side = side_of(change.lane);
    const std::uint32_t known = image::get_register(side.known, change.lane.number) & ~std::uint32_t{change.mask};
    image::set_register(side.known, change.lane.number, static_cast<std::uint16_t>(known));
  }
}

std::span<const LaneChange> Outbox::changes(const image::Tables& events) {
  changes_.clear();
  for (const Side& side : sides_) {
    const auto words =
        side.table == Table::discrete_input ? events.discrete_inputs.words : events.input_registers.words;
    for (std::size_t word = 0; word < side.mapped.size(); ++word) {
      const std::uint64_t free = side.mapped[word] & ~side.held[word];
      const std::uint64_t differs = free & ((words[word] ^ side.confirmed[word]) | ~side.known[word]);
      add_lanes(changes_, side.table, word, differs, words[word]);
    }
  }
  return changes_;
}

void Outbox::confirm(std::span<const LaneChange> changes) noexcept {
  for (const LaneChange& change : changes) {
    Side& side = side_of(change.lane);
    const std::uint32_t lane = change.lane.number;
    const std::uint32_t kept = image::get_register(side.confirmed, lane) & ~std::uint32_t{change.mask};
    image::set_register(side.confirmed, lane, static_cast<std::uint16_t>(kept | (change.value & change.mask)));
    const std::uint32_t known = image::get_register(side.known, lane) | change.mask;
    image::set_register(side.known, lane, static_cast<std::uint16_t>(known));
  }
}

std::vector<LaneChange> Outbox::differences(std::span<const std::uint64_t> discrete_inputs,
                                            std::span<const std::uint64_t> input_registers) const {
  std::vector<LaneChange> lanes;
  for (const Side& side : sides_) {
    const auto words = side.table == Table::discrete_input ? discrete_inputs : input_registers;
    for (std::size_t word = 0; word < side.mapped.size(); ++word) {
      add_lanes(lanes, side.table, word, (words[word] ^ side.confirmed[word]) & side.known[word], words[word]);
    }
  }
  return lanes;
}

}  // namespace symplant::link::client
