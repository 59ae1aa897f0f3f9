// The symbols of one direction: as the link or the model made them, what overrides them, and the result.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/dirty_set.hpp"

namespace symplant::engine {

/// What replaces the value of a symbol that the link or the model made. A force of the user hides what malfunctions do.
struct Override {
  enum class Kind : std::uint8_t {
    none,
    value,
    opposite,  ///< of a bit: the opposite of what was made
  };
  Kind kind = Kind::none;
  bool by_malfunction = false;
  std::uint64_t value = 0;  ///< of a bit: 0 or 1
};

/// The numeric symbols of one direction.
struct ValuePlane {
  void take(Arena& arena, std::size_t slots) noexcept;
  std::uint64_t effective(std::uint32_t slot) const noexcept {
    return (forced[slot / 64] & bit_in_word(slot)) != 0 ? forced_to[slot] : made[slot];
  }
  /// `values` are updated when dirty slots are examined.
  void set(std::uint32_t slot, const Override& to) noexcept {
    const bool is_set = to.kind != Override::Kind::none;
    set_bit(forced[slot / 64], slot, is_set);
    set_bit(broken[slot / 64], slot, is_set && to.by_malfunction);
    forced_to[slot] = is_set ? to.value : 0;
    dirty.mark(slot);
  }
  /// Whether the user forces it.
  bool is_forced(std::uint32_t slot) const noexcept {
    return (forced[slot / 64] & ~broken[slot / 64] & bit_in_word(slot)) != 0;
  }

  std::uint64_t* made;    ///< before forces: set by the link (as sampled) or by the model
  std::uint64_t* values;  ///< after forces
  std::uint64_t* forced;  ///< one bit per slot
  std::uint64_t* forced_to;
  std::uint64_t* broken;  ///< one bit per slot: those that a malfunction forces
  BlockSet dirty;         ///< slots to examine when the next instant begins or this round ends
};

/// The BOOL symbols of one direction.
struct BitPlane {
  void take(Arena& arena, std::size_t words) noexcept;
  std::uint64_t effective(std::uint32_t word) const noexcept {
    if (forced[word] == 0) return made_[word];
    return (made_[word] & ~forced[word]) | forced_on[word] | (opposite[word] & ~made_[word]);
  }
  /// The word before forces: set by the link (as sampled) or by the model.
  std::uint64_t made(std::uint32_t word) const noexcept {
    return forced[word] != 0 || dirty.has(word) ? made_[word] : bits[word];
  }
  /// The word after forces, also while it is dirty.
  std::uint64_t current(std::uint32_t word) const noexcept {
    const std::uint64_t before = made(word);
    return (before & ~forced[word]) | forced_on[word] | (opposite[word] & ~before);
  }
  /// Changes the word before forces; returns it after forces. The caller sets `bits`; the word must not be dirty.
  std::uint64_t sample(std::uint32_t word, std::uint64_t value) noexcept {
    if (forced[word] == 0) return value;
    made_[word] = value;
    return effective(word);
  }
  /// Changes the word before forces; `bits` are updated when dirty words are examined.
  void make(std::uint32_t word, std::uint64_t value) noexcept {
    dirty.mark(word);
    made_[word] = value;
  }
  /// Overrides a bit, or ends that; `bits` are updated when dirty words are examined.
  void set(std::uint32_t bit, const Override& to) noexcept {
    const std::uint32_t word = bit / 64;
    make(word, made(word));
    set_bit(forced[word], bit, to.kind != Override::Kind::none);
    set_bit(forced_on[word], bit, to.kind == Override::Kind::value && to.value != 0);
    set_bit(opposite[word], bit, to.kind == Override::Kind::opposite);
    set_bit(broken[word], bit, to.kind != Override::Kind::none && to.by_malfunction);
  }
  bool is_overridden(std::uint32_t bit) const noexcept { return (forced[bit / 64] & bit_in_word(bit)) != 0; }
  /// Whether the user forces it.
  bool is_forced(std::uint32_t bit) const noexcept {
    return (forced[bit / 64] & ~broken[bit / 64] & bit_in_word(bit)) != 0;
  }

  std::uint64_t* bits;       ///< after forces
  std::uint64_t* forced;     ///< the bits that are overridden
  std::uint64_t* forced_on;  ///< those of them that are on
  std::uint64_t* opposite;   ///< those of them that are the opposite of what was made
  std::uint64_t* broken;     ///< those of them that a malfunction overrides
  BlockSet dirty;            ///< words to examine when the next instant begins or this round ends

 private:
  std::uint64_t* made_;  ///< valid only for words that are dirty or have a force; `bits` has the value of the others
};

}  // namespace symplant::engine
