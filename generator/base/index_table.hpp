// A hash table of indexes into a table that holds the keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_memory.hpp"

namespace symplant::base {

/// Indexes are numbers below 0xFFFFFFFF. A search compares a key only if all 32 stored bits of its hash agree, so that
/// it mostly costs one memory access. O(1) with a good hash.
class IndexTable {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFF'FFFF;

  IndexTable() = default;
  /// Reserves room for `expected` keys.
  explicit IndexTable(std::size_t expected) {
    if (expected != 0) resize(expected);
  }

  std::size_t size() const { return size_; }

  /// The index of a key; kNothing if it is not in the table. `is_at(index)` returns whether the key is at an index.
  template <class IsAt>
  std::uint32_t find(std::uint64_t hash, const IsAt& is_at) const {
    return slots_.empty() ? kNothing : slots_[slot_of(folded(hash), is_at)].index;
  }

  /// The index of a key. A new key is added with `index`.
  template <class IsAt>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t index, const IsAt& is_at) {
    if ((size_ + 1) * 2 > slots_.size()) resize(size_ + 1);
    const std::uint32_t kept = folded(hash);
    Slot& slot = slots_[slot_of(kept, is_at)];
    if (slot.index != kNothing) return slot.index;
    slot = {kept, index};
    ++size_;
    return index;
  }

  /// Fetches the slot of a hash into the cache, before a search for it. Inlined in any case: g++ 12 drops calls of
  /// functions that only prefetch.
  [[gnu::always_inline]] void prefetch(std::uint64_t hash) const {
    if (!slots_.empty()) __builtin_prefetch(&slots_[folded(hash) & (slots_.size() - 1)], 1);
  }

  /// Changes the index of a key that is in the table.
  template <class IsAt>
  void move(std::uint64_t hash, std::uint32_t index, const IsAt& is_at) {
    slots_[slot_of(folded(hash), is_at)].index = index;
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t index = kNothing;
  };

  static std::uint32_t folded(std::uint64_t hash) {
    return static_cast<std::uint32_t>((hash * 0x9E37'79B9'7F4A'7C15U) >> 32U);
  }

  /// The slot of the key, or the empty slot for it.
  template <class IsAt>
  std::size_t slot_of(std::uint32_t kept, const IsAt& is_at) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = kept & mask;
    while (slots_[at].index != kNothing && (slots_[at].hash != kept || !is_at(slots_[at].index))) at = (at + 1) & mask;
    return at;
  }

  void resize(std::size_t expected) {
    std::size_t size = 16;
    while (size < 2 * expected || size <= slots_.size()) size *= 2;
    std::vector<Slot> old;
    old.swap(slots_);
    reserve_large(slots_, size);
    slots_.resize(size);
    for (const Slot& slot : old) {
      if (slot.index == kNothing) continue;
      std::size_t at = slot.hash & (size - 1);
      while (slots_[at].index != kNothing) at = (at + 1) & (size - 1);
      slots_[at] = slot;
    }
  }

  std::vector<Slot> slots_;  ///< a power of two in number, at least half of them empty
  std::size_t size_ = 0;
};

}  // namespace symplant::base
