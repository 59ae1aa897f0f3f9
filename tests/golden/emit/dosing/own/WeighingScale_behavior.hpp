// How devices of the plant dosing behave that have the behaviour WeighingScale. Written once by symplant; yours from
// then on: symplant generate --behaviours writes it again only where it is missing.
#pragma once

#include <cstdint>
#include <optional>

#include "types_gen.hpp"

namespace dosing {

/// What you define here takes the place of the model's own rule; what you leave out is the model's. All functions are
/// static and noexcept; they are called inside their device's step, so they must be short and must not use heap, locks or
/// system calls (`--rt-check N` looks). There is no object of the class: what a device remembers is its Memory.
///
/// L1_DOSE_SCALE1
/// L1_DOSE_SCALE2
class WeighingScale : public Scale {
 public:
  /// What each device remembers: zeros at the start; saved, restored and digested with the plant. Without pointers and
  /// gaps, 4096 bytes at most. In the functions: `view.memory<Memory>()`.
  // struct Memory { std::uint64_t count; };

  /// How long a way takes, in ns, asked when the device leaves or turns round.
  // static Time takes(Look& look, Transition transition) noexcept { return look.model_takes(transition); }

  /// How long the cause of a transition must hold before the device leaves, in ns, asked when it begins to hold.
  // static Time after(Look& look, Transition transition) noexcept { return look.model_after(transition); }

  /// One more state that the device wants, beside those that operations command; asked in every step.
  // static std::optional<State> wanted(const Look&) noexcept { return std::nullopt; }

  /// The device has settled in a state; its events are switched already.
  // static void entered(View&, State) noexcept {}

  /// The device has left a state; its events are switched already.
  // static void left(View&, State) noexcept {}

  /// The time has come that view.wake_at() or view.wake_after() asked for.
  // static void woken(View&) noexcept {}
};

}  // namespace dosing
