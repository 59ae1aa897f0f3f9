// The hand-written limit: the cost of a plant of two-state devices that only moves, without any other feature of the
// model. Packed images, a wheel of 10 ms slots, no types, names, rounds or arming. Frozen: it is the baseline.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace symplant::bench {

/// Device d has operations 2d and 2d + 1 and events 2d and 2d + 1; a travel takes `travel_ticks` (below 128) slots.
class LimitPlant {
 public:
  LimitPlant(std::uint32_t devices, std::uint32_t travel_ticks)
      : travel_(travel_ticks),
        operations(words(devices)),
        last_(words(devices)),
        events(words(devices)),
        changed(words(devices)),
        devices_(devices) {
    wheel_.fill(kNone);
    for (std::uint32_t d = 0; d < devices; ++d) events[d / 32] |= std::uint64_t{1} << (2 * (d % 32));
  }

  void tick() {
    ++now_;
    arrive();
    const auto words = static_cast<std::uint32_t>(operations.size());
    std::uint64_t* const seen = last_.data();
    const std::uint64_t* const given = operations.data();
    for (std::uint32_t word = 0; word < words; ++word) {
      const std::uint64_t changed_bits = given[word] ^ seen[word];
      if (changed_bits == 0) continue;
      seen[word] = given[word];
      for (std::uint64_t risen = changed_bits & given[word]; risen != 0; risen &= risen - 1) {
        start(word, static_cast<std::uint32_t>(std::countr_zero(risen)));
      }
    }
  }

  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

 private:
  static std::size_t words(std::uint32_t devices) { return (devices + 31) / 32; }

  void arrive() {
    std::uint32_t d = wheel_[now_ % 128];
    wheel_[now_ % 128] = kNone;
    std::uint64_t* const on = events.data();
    std::uint64_t* const came = changed.data();
    Device* const devices = devices_.data();
    while (d != kNone) {
      Device& device = devices[d];
      device.state &= 1;
      const std::uint64_t bit = std::uint64_t{1} << (2 * (d % 32) + device.state);
      on[d / 32] |= bit;
      came[d / 32] |= bit;
      d = device.next;
    }
  }

  void start(std::uint32_t word, std::uint32_t bit) {
    const std::uint32_t d = word * 32 + bit / 2;
    const std::uint32_t target = bit & 1;
    Device& device = devices_[d];
    if (device.state == target || device.state > 1) return;
    events[word] &= ~(std::uint64_t{1} << (bit ^ 1));
    device.state = 2 | target;
    std::uint32_t& head = wheel_[(now_ + travel_) % 128];
    device.next = head;
    head = d;
  }

  struct Device {
    std::uint32_t next;
    std::uint32_t state;  ///< bit 0: state or target, bit 1: moving
  };

  std::uint32_t travel_;
  std::uint32_t now_ = 0;
  std::array<std::uint32_t, 128> wheel_{};

 public:
  std::vector<std::uint64_t> operations;
  std::vector<std::uint64_t> last_;
  std::vector<std::uint64_t> events;
  std::vector<std::uint64_t> changed;  ///< events that turned on since the controller last read them

 private:
  std::vector<Device> devices_;
};

}  // namespace symplant::bench
