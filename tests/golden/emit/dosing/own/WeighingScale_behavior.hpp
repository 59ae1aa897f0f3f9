// The custom behavior WeighingScale of devices of the plant dosing. symplant wrote this file once; it is yours to
// edit: symplant generate --behaviours writes it again only if it is missing.
#pragma once

#include <cstdint>
#include <optional>

#include "types_gen.hpp"

namespace dosing {

/// A function that you define here replaces the model's rule; the model's rules apply to all others. All functions are
/// static and noexcept. The engine calls them inside the step of their device: they must be short and must not use
/// heap, locks or system calls (`--rt-check N` checks this). The class has no objects: a device keeps its data in a
/// Memory.
///
/// L1_DOSE_SCALE1
/// L1_DOSE_SCALE2
class WeighingScale : public Scale {
 public:
  /// The functions that this class defines; the compiler reports one that is missing, misspelt or not listed.
  // using hooks = Hooks<Hook::entered, Hook::woken>;

  /// The data of each device: zeros at the start; saved, restored and digested with the plant. No pointers and no
  /// padding, at most 4096 bytes. The functions access it by `view.memory<Memory>()`.
  // struct Memory { std::uint64_t count; };

  /// Called once before the first instant, and after a reset: a device without a transition can request its first call
  /// of woken() here.
  // static void started(View&) noexcept {}

  /// The travel time of a transition in ns. Called when the device leaves a state or reverses.
  // static Time takes(Look& look, Transition transition) noexcept { return look.model_takes(transition); }

  /// The delay of a transition in ns: how long its cause must hold. Called when the cause begins to hold.
  // static Time after(Look& look, Transition transition) noexcept { return look.model_after(transition); }

  /// An additional target state, next to those that operations command. Called in every step.
  // static std::optional<State> wanted(const Look&) noexcept { return std::nullopt; }

  /// Called when the device has settled in a state and its events are switched.
  // static void entered(View&, State) noexcept {}

  /// Called when the device has left a state and its events are switched.
  // static void left(View&, State) noexcept {}

  /// Called at the time that view.wake_at() or view.wake_after() requested.
  // static void woken(View&) noexcept {}

  // You can also replace d_ext, d_int, l_enter and l_leave of Scale; docs/behaviours.md shows how.
};

}  // namespace dosing
