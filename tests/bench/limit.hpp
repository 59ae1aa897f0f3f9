// The hand-written limit: what a plant of two-state devices costs when it does nothing that a model asks for beyond
// moving. Packed images, a wheel of 10 ms slots, no types, no names, no rounds, no arming. Frozen: it is the measure.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace symplant::bench {

/// Device d has operations 2d and 2d + 1 and events alike; every travel takes `travel_ticks` (below 128) slots.
class LimitPlant {
 public:
  LimitPlant(std::uint32_t devices, std::uint32_t travel_ticks)
      : travel_(travel_ticks),
        operations(words(devices)),
        last_(words(devices)),
        events(words(devices)),
        changed(words(devices)),
        state_(devices),
        next_(devices) {
    wheel_.fill(kNone);
    for (std::uint32_t d = 0; d < devices; ++d) events[d / 32] |= std::uint64_t{1} << (2 * (d % 32));
  }

  void tick() {
    ++now_;
    std::uint32_t d = wheel_[now_ % 128];
    wheel_[now_ % 128] = kNone;
    while (d != kNone) {
      const std::uint64_t bit = std::uint64_t{1} << (2 * (d % 32) + (state_[d] & 1));
      events[d / 32] |= bit;
      changed[d / 32] |= bit;
      state_[d] &= 1;
      d = next_[d];
    }
    for (std::uint32_t word = 0; word < operations.size(); ++word) {
      std::uint64_t risen = (operations[word] ^ last_[word]) & operations[word];
      last_[word] = operations[word];
      for (; risen != 0; risen &= risen - 1) start(word, static_cast<std::uint32_t>(std::countr_zero(risen)));
    }
  }

  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

 private:
  static std::size_t words(std::uint32_t devices) { return (devices + 31) / 32; }

  void start(std::uint32_t word, std::uint32_t bit) {
    const std::uint32_t d = word * 32 + bit / 2;
    const auto target = static_cast<std::uint8_t>(bit & 1);
    if (state_[d] == target || state_[d] > 1) return;
    events[word] &= ~(std::uint64_t{1} << (bit ^ 1));
    state_[d] = static_cast<std::uint8_t>(2 | target);
    std::uint32_t& head = wheel_[(now_ + travel_) % 128];
    next_[d] = head;
    head = d;
  }

  std::uint32_t travel_;
  std::uint32_t now_ = 0;
  std::array<std::uint32_t, 128> wheel_{};

 public:
  std::vector<std::uint64_t> operations;
  std::vector<std::uint64_t> last_;
  std::vector<std::uint64_t> events;
  std::vector<std::uint64_t> changed;  ///< events that came on since the controller last looked

 private:
  std::vector<std::uint8_t> state_;  ///< bit 0: state or target, bit 1: moving
  std::vector<std::uint32_t> next_;
};

}  // namespace symplant::bench
