// What a behaviour remembers lies in the plant's block, byte by byte: proof at compile time that this can be.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

#include "symplant/engine/behaviour.hpp"

namespace symplant::plant {
namespace detail {

/// Whether all bytes of a fresh object are 0. No constant expression where it has bytes without a value (padding), or
/// what has no bytes of its own while compiling: pointers, references, unions, bit-fields.
template <class Memory>
constexpr bool begins_as_zeros() {
  for (const unsigned char byte : std::bit_cast<std::array<unsigned char, sizeof(Memory)>>(Memory{})) {
    if (byte != 0) return false;
  }
  return true;
}

template <class Memory>
concept PlainBytes = requires {
  typename std::bool_constant<(begins_as_zeros<Memory>(), true)>;
};

}  // namespace detail

/// Does not compile where a type cannot be a behaviour's memory, and says why.
template <class Memory>
constexpr void check_behaviour_memory() noexcept {
  static_assert(std::is_trivially_copyable_v<Memory>,
                "a behaviour's Memory is saved and restored byte by byte: no strings, no containers, no destructors");
  static_assert(sizeof(Memory) <= engine::kMaxBehaviourMemory, "a behaviour's Memory holds 4096 bytes at most");
  static_assert(alignof(Memory) <= 8, "a behaviour's Memory is aligned to 8 bytes at most");
  if constexpr (std::is_trivially_copyable_v<Memory> && sizeof(Memory) <= engine::kMaxBehaviourMemory) {
    static_assert(detail::PlainBytes<Memory>,
                  "a behaviour's Memory is digested byte by byte: fill its gaps with members of your own (say "
                  "`std::uint8_t unused[3]`), and leave pointers, references, unions and bit-fields out");
    if constexpr (detail::PlainBytes<Memory>) {
      static_assert(detail::begins_as_zeros<Memory>(),
                    "a behaviour's Memory begins as zeros: leave initial values other than 0 out");
    }
  }
}

}  // namespace symplant::plant
