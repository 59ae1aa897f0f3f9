// Numbers computed from an input, so that the same input is always treated the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symplant::fuzz {

class Dice {
 public:
  explicit Dice(const std::vector<std::uint8_t>& seed) {
    for (const std::uint8_t byte : seed) state_ = (state_ ^ byte) * 1099511628211U;
  }
  std::size_t below(std::size_t end) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state_ >> 33) % end;
  }

 private:
  std::uint64_t state_ = 1469598103934665603U;
};

}  // namespace symplant::fuzz
