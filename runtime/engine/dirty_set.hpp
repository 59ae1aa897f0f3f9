// Lists of fixed size, and sets of places that were written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"

namespace symplant::engine {

constexpr std::uint64_t bit_in_word(std::uint32_t bit) noexcept { return std::uint64_t{1} << (bit % 64); }

/// A list in memory of fixed size, large enough for all that it can ever hold.
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

/// Places (words, slots, units), each at most once, in the order in which they were marked.
struct DirtySet {
  void take(Arena& arena, std::size_t places) noexcept {
    list.take(arena, places);
    marks = arena.take<std::uint64_t>((places + 63) / 64);
  }
  /// False where it was marked already.
  bool mark(std::uint32_t place) noexcept {
    std::uint64_t& word = marks[place / 64];
    if ((word & bit_in_word(place)) != 0) return false;
    word |= bit_in_word(place);
    list.add(place);
    return true;
  }
  bool empty() const noexcept { return list.size == 0; }
  /// Calls `function` for each; the set is empty afterwards. Nothing may be marked meanwhile.
  template <class Function>
  void take_all(Function function) noexcept {
    for (std::uint32_t i = 0; i < list.size; ++i) {
      const std::uint32_t place = list.items[i];
      marks[place / 64] = 0;
      function(place);
    }
    list.size = 0;
  }
  void clear() noexcept {
    std::uint64_t* const all = marks;
    for (const std::uint32_t place : list.view()) all[place / 64] = 0;
    list.size = 0;
  }

  List<std::uint32_t> list;
  std::uint64_t* marks;
};

/// A DirtySet that lies in the flat block: its size does, too.
struct BlockSet {
  void take(Arena& arena, std::size_t places) noexcept {
    size = arena.take<std::uint64_t>(1);
    items = arena.take<std::uint32_t>(places);
    marks = arena.take<std::uint64_t>((places + 63) / 64);
  }
  void mark(std::uint32_t place) noexcept {
    std::uint64_t& word = marks[place / 64];
    if ((word & bit_in_word(place)) != 0) return;
    word |= bit_in_word(place);
    items[(*size)++] = place;
  }
  bool empty() const noexcept { return *size == 0; }
  /// Calls `function` for each; the set is empty afterwards. Nothing may be marked meanwhile.
  template <class Function>
  void take_all(Function function) noexcept {
    const std::uint64_t count = *size;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint32_t place = items[i];
      marks[place / 64] = 0;
      function(place);
    }
    *size = 0;
  }

  std::uint64_t* size;
  std::uint32_t* items;
  std::uint64_t* marks;
};

}  // namespace symplant::engine
