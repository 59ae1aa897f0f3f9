// One part of several that share the work.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

namespace symplant::batch {

/// `2/8`: every eighth piece of work, from the second one on.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;

  bool has(std::size_t number) const { return number % count == index - 1; }
};

/// Nothing for a text that is not I/N with I from 1 to N.
inline std::optional<Shard> shard_of(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(index.ptr + 1, end, shard.count);
  const bool sound = count.ec == std::errc() && count.ptr == end && shard.index >= 1 && shard.index <= shard.count;
  return sound ? std::optional(shard) : std::nullopt;
}

}  // namespace symplant::batch
