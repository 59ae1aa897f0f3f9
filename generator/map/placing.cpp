// Where the channels of a map are in the memory of a PLC's inputs and outputs.
#include "map/placing.hpp"

#include <algorithm>
#include <optional>

#include "symplant/link/modbus/transfer_range.hpp"

namespace symplant::map {
namespace {

constexpr std::uint32_t kWordBits = 16;
constexpr std::uint32_t kByteBits = 8;
constexpr std::uint32_t kLongWord = 4;  ///< words of the largest number

bool is_bits(const Channel& channel) { return has_bits(channel.table); }

/// The address that the list gives to the channel's first number; nothing if it gives none, or its symbols disagree.
std::optional<std::uint32_t> listed_address(const LinkView& view, const Channel& channel) {
  std::vector<const link::modbus::IoPoint*> points = link::modbus::points_of(view.served(), channel.table);
  std::erase_if(points, [&](const link::modbus::IoPoint* point) {
    return point->number < channel.first || point->number >= channel.end();
  });
  const auto offset = link::modbus::listed_offset(view.of->tables, points);
  if (!offset || *offset + channel.first < 0) return std::nullopt;
  const std::int64_t first = *offset + channel.first;
  if (is_bits(channel) && first % kByteBits != 0) return std::nullopt;
  return static_cast<std::uint32_t>(first);
}

class Placing {
 public:
  Placing(const LinkView& view, IoMemory memory)
      : view_(view), memory_(memory), channels_(channels_of(view.served())), at_(channels_.size()) {}

  std::vector<PlacedChannel> run() {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (channels_[i].part == Channel::Part::symbols) at_[i] = listed_address(view_, channels_[i]);
    }
    if (any_overlap()) std::fill(at_.begin(), at_.end(), std::nullopt);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (at_[i]) continue;
      at_[i] = channels_[i].first;
      if (overlaps_another(i)) at_[i] = after_the_last(i);
    }
    std::vector<PlacedChannel> placed;
    for (std::size_t i = 0; i < channels_.size(); ++i) placed.push_back({channels_[i], *at_[i]});
    return placed;
  }

 private:
  bool same_memory(const Channel& a, const Channel& b) const {
    return memory_ == IoMemory::overlaid ? is_event(a.table) == is_event(b.table) : a.table == b.table;
  }
  /// In bits.
  std::uint64_t begin_of(std::size_t i) const {
    return std::uint64_t{*at_[i]} * (is_bits(channels_[i]) ? 1 : kWordBits);
  }
  std::uint64_t end_of(std::size_t i) const {
    return begin_of(i) + std::uint64_t{channels_[i].count} * (is_bits(channels_[i]) ? 1 : kWordBits);
  }

  bool overlaps_another(std::size_t i) const {
    for (std::size_t other = 0; other < channels_.size(); ++other) {
      if (other == i || !at_[other] || !same_memory(channels_[i], channels_[other])) continue;
      if (begin_of(i) < end_of(other) && begin_of(other) < end_of(i)) return true;
    }
    return false;
  }

  bool any_overlap() const {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (at_[i] && overlaps_another(i)) return true;
    }
    return false;
  }

  /// A free address after all other channels, which leaves numbers of several words where their size divides it.
  std::uint32_t after_the_last(std::size_t i) const {
    std::uint64_t end = 0;
    for (std::size_t other = 0; other < channels_.size(); ++other) {
      if (other != i && at_[other] && same_memory(channels_[i], channels_[other])) end = std::max(end, end_of(other));
    }
    if (is_bits(channels_[i])) return static_cast<std::uint32_t>((end + kByteBits - 1) / kByteBits * kByteBits);
    const std::uint64_t word = (end + kWordBits - 1) / kWordBits;
    const std::uint64_t rounded = (word + kLongWord - 1) / kLongWord * kLongWord;
    return static_cast<std::uint32_t>(rounded + channels_[i].first % kLongWord);
  }

  const LinkView& view_;
  const IoMemory memory_;
  const std::vector<Channel> channels_;
  std::vector<std::optional<std::uint32_t>> at_;
};

}  // namespace

std::vector<PlacedChannel> place(const LinkView& view, IoMemory memory) { return Placing(view, memory).run(); }

}  // namespace symplant::map
