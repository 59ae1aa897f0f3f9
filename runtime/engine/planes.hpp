// The symbols of one direction: as the link or the model made them, their forces, and the result.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/dirty_set.hpp"

namespace symplant::engine {

/// The numeric symbols of one direction, with their forces.
struct ValuePlane {
  void take(Arena& arena, std::size_t slots) noexcept;
  std::uint64_t effective(std::uint32_t slot) const noexcept {
    return (forced[slot / 64] & bit_in_word(slot)) != 0 ? forced_to[slot] : made[slot];
  }

  std::uint64_t* made;    ///< before forces: set by the link (as sampled) or by the model
  std::uint64_t* values;  ///< after forces
  std::uint64_t* forced;  ///< one bit per slot
  std::uint64_t* forced_to;
  BlockSet dirty;  ///< slots to examine when the next instant begins or this round ends
};

/// The BOOL symbols of one direction, with their forces.
struct BitPlane {
  void take(Arena& arena, std::size_t words) noexcept;
  std::uint64_t effective(std::uint32_t word) const noexcept { return (made_[word] & ~forced[word]) | forced_on[word]; }
  /// The word before forces: set by the link (as sampled) or by the model.
  std::uint64_t made(std::uint32_t word) const noexcept {
    return forced[word] != 0 || dirty.has(word) ? made_[word] : bits[word];
  }
  /// Changes the word before forces; returns it after forces. The caller sets `bits`; the word must not be dirty.
  std::uint64_t sample(std::uint32_t word, std::uint64_t value) noexcept {
    if (forced[word] == 0) return value;
    made_[word] = value;
    return effective(word);
  }
  /// Changes the word before forces; `bits` follow when dirty words are examined.
  void make(std::uint32_t word, std::uint64_t value) noexcept {
    dirty.mark(word);
    made_[word] = value;
  }
  /// Forces or releases bits of a word; `bits` follow when dirty words are examined.
  void force(std::uint32_t word, std::uint64_t mask, bool on, bool off) noexcept {
    make(word, made(word));
    forced[word] = on || off ? forced[word] | mask : forced[word] & ~mask;
    forced_on[word] = on ? forced_on[word] | mask : forced_on[word] & ~mask;
  }

  std::uint64_t* bits;  ///< after forces
  std::uint64_t* forced;
  std::uint64_t* forced_on;  ///< the forced bits that are forced on
  BlockSet dirty;            ///< words to examine when the next instant begins or this round ends

 private:
  std::uint64_t* made_;  ///< only of words that are dirty or have a force; of the others `bits` are the same
};

}  // namespace symplant::engine
