// The functions that a custom behavior may define, as a list that the compiler checks.
#pragma once

#include <cstdint>

namespace symplant::tables {

/// A function of a custom behavior (docs/behaviours.md).
enum class Hook : std::uint8_t { started, takes, after, wanted, entered, left, woken };

/// `using hooks = Hooks<Hook::entered, Hook::woken>;` in a behavior's class: the functions that it defines.
template <Hook... Listed>
struct Hooks {
  static constexpr bool lists(Hook hook) noexcept { return ((Listed == hook) || ...); }
};

}  // namespace symplant::tables
