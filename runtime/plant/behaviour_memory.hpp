// Checks at compile time that a type can be a behavior's memory, which lies in the plant's block as plain bytes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

#include "symplant/engine/behaviour.hpp"

namespace symplant::plant {
namespace detail {

/// Whether all bytes of a new object are 0. It is not a constant expression if the type has padding, pointers,
/// references, unions or bit-fields.
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

/// Fails to compile, with a reason, if a type cannot be a behavior's memory.
template <class Memory>
constexpr void check_behaviour_memory() noexcept {
  static_assert(std::is_trivially_copyable_v<Memory>,
                "a behavior's Memory is saved and restored byte by byte; use no strings, containers or destructors");
  static_assert(sizeof(Memory) <= engine::kMaxBehaviourMemory, "a behavior's Memory holds 4096 bytes at most");
  static_assert(alignof(Memory) <= 8, "a behavior's Memory is aligned to 8 bytes at most");
  if constexpr (std::is_trivially_copyable_v<Memory> && sizeof(Memory) <= engine::kMaxBehaviourMemory) {
    static_assert(detail::PlainBytes<Memory>,
                  "a behavior's Memory is digested byte by byte; fill its padding with unused members (such as "
                  "`std::uint8_t unused[3]`), and remove pointers, references, unions and bit-fields");
    if constexpr (detail::PlainBytes<Memory>) {
      static_assert(detail::begins_as_zeros<Memory>(),
                    "a behavior's Memory begins as zeros; remove initial values other than 0");
    }
  }
}

}  // namespace symplant::plant
