// Lists of fixed capacity, and sets of positions that were written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"

namespace symplant::engine {

constexpr std::uint64_t bit_in_word(std::uint32_t bit) noexcept { return std::uint64_t{1} << (bit % 64); }

constexpr std::uint64_t with_bit(std::uint64_t word, std::uint32_t bit, bool on) noexcept {
  return on ? word | bit_in_word(bit) : word & ~bit_in_word(bit);
}

constexpr void set_bit(std::uint64_t& word, std::uint32_t bit, bool on) noexcept { word = with_bit(word, bit, on); }

/// A list of fixed capacity. The capacity covers the worst case: add() does not check it.
template <class T>
struct List {
  T* items;
  std::uint32_t size;

  void take(Arena& arena, std::size_t capacity) noexcept {
    items = arena.take<T>(capacity);
    size = 0;
  }
  void add(T item) noexcept { items[size++] = item; }
  std::span<const T> view() const noexcept { return {items, size}; }
};

/// Positions (words, slots, units), each at most once, in the order in which they were marked.
struct DirtySet {
  void take(Arena& arena, std::size_t positions) noexcept {
    list.take(arena, positions);
    marks = arena.take<std::uint64_t>((positions + 63) / 64);
  }
  /// False if the position was marked already.
  bool mark(std::uint32_t position) noexcept {
    std::uint64_t& word = marks[position / 64];
    if ((word & bit_in_word(position)) != 0) return false;
    word |= bit_in_word(position);
    list.add(position);
    return true;
  }
  bool empty() const noexcept { return list.size == 0; }
  /// Calls `function` for each; the set is empty afterwards. Nothing may be marked meanwhile.
  template <class Function>
  void take_all(Function function) noexcept {
    for (std::uint32_t i = 0; i < list.size; ++i) {
      const std::uint32_t position = list.items[i];
      marks[position / 64] = 0;
      function(position);
    }
    list.size = 0;
  }
  void clear() noexcept {
    std::uint64_t* const all = marks;
    for (const std::uint32_t position : list.view()) all[position / 64] = 0;
    list.size = 0;
  }

  List<std::uint32_t> list;
  std::uint64_t* marks;
};

/// A list whose data, with its size, lies in the flat block.
struct BlockList {
  void take(Arena& arena, std::size_t capacity) noexcept {
    size = arena.take<std::uint64_t>(1);
    items = arena.take<std::uint32_t>(capacity);
  }
  void add(std::uint32_t item) noexcept { items[(*size)++] = item; }
  bool empty() const noexcept { return *size == 0; }
  /// The list is empty afterwards; the returned items are valid until the next add().
  std::span<const std::uint32_t> take_all() noexcept {
    const std::size_t count = *size;
    *size = 0;
    return {items, count};
  }

  std::uint64_t* size;
  std::uint32_t* items;
};

/// A DirtySet whose data, with its size, lies in the flat block.
struct BlockSet {
  void take(Arena& arena, std::size_t positions) noexcept {
    size = arena.take<std::uint64_t>(1);
    items = arena.take<std::uint32_t>(positions);
    marks = arena.take<std::uint64_t>((positions + 63) / 64);
  }
  void mark(std::uint32_t position) noexcept {
    std::uint64_t& word = marks[position / 64];
    if ((word & bit_in_word(position)) != 0) return;
    word |= bit_in_word(position);
    items[(*size)++] = position;
  }
  bool has(std::uint32_t position) const noexcept { return (marks[position / 64] & bit_in_word(position)) != 0; }
  bool empty() const noexcept { return *size == 0; }
  /// Calls `function` for each; the set is empty afterwards. Nothing may be marked meanwhile.
  template <class Function>
  void take_all(Function function) noexcept {
    const std::uint32_t* const begin = items;
    const std::uint32_t* const end = begin + *size;
    std::uint64_t* const all = marks;
    *size = 0;
    for (const std::uint32_t* position = begin; position != end; ++position) {
      all[*position / 64] = 0;
      function(*position);
    }
  }

  std::uint64_t* size;
  std::uint32_t* items;
  std::uint64_t* marks;
};

}  // namespace symplant::engine
