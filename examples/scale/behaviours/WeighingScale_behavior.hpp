// The behavior of the scales of the plant dosing: material flows in at a rate, and the weight rises meanwhile.
#pragma once

#include <algorithm>
#include <cstdint>

#include "types_gen.hpp"

namespace dosing {

/// The travel time to FULL2 is the time that the target needs at the flow at the start. The weight is updated every
/// 100 ms. A batch exceeds its target by up to 20 g. The description gives the time of emptying.
class WeighingScale : public Scale {
 public:
  using hooks = Hooks<Hook::takes, Hook::entered, Hook::left, Hook::woken>;

  /// Weights are integers in g, so that all computers compute the same. Each member has 8 bytes: no padding.
  struct Memory {
    std::int64_t batches;
    std::int64_t target;  ///< of the batch that flows in
    std::int64_t flow;    ///< g/s, while it flows
    std::int64_t began;   ///< when it began to flow, ns
  };

  static Time takes(Look& look, Transition transition) noexcept {
    if (transition.to() != State::FULL2) return look.model_takes(transition);
    return target(look) * kSecond / flow(look);
  }

  static void left(View& view, State state) noexcept {
    auto& memory = view.memory<Memory>();
    if (state == State::FULL2) return;
    memory.target = target(view);
    memory.flow = flow(view);
    memory.began = view.now();
    view.wake_after(kShown);
  }

  static void woken(View& view) noexcept {
    const auto& memory = view.memory<Memory>();
    const Time flowed = view.now() - memory.began;
    show(view, std::min(memory.target, memory.flow * (flowed / kMillisecond) / 1000));
    view.wake_after(kShown);
  }

  static void entered(View& view, State state) noexcept {
    view.wake_at(symplant::tables::kNever);
    if (state == State::EMPTY1) {
      show(view, 0);
      return;
    }
    auto& memory = view.memory<Memory>();
    ++memory.batches;
    show(view, memory.target + static_cast<std::int64_t>(view.draw() % 21));
    view.set_value<Value::I_BATCHES>(static_cast<std::int16_t>(memory.batches));
  }

 private:
  static constexpr Time kShown = 100 * kMillisecond;

  /// The target of the PLC in g, limited to 1 t.
  static std::int64_t target(const Look& look) noexcept {
    const double kilograms = look.value<Value::O_TARGET>();
    return kilograms > 0 ? static_cast<std::int64_t>(std::min(kilograms, 1000.0) * 1000.0) : 0;
  }
  /// Coarse with the hopper's gate open, else fine.
  static std::int64_t flow(const Look& look) noexcept { return look.input(Input::hopper_open) ? 10'000 : 2'000; }
  static void show(View& view, std::int64_t grams) noexcept {
    view.set_value<Value::I_WEIGHT>(static_cast<double>(grams) / 1000.0);
  }
};

}  // namespace dosing
