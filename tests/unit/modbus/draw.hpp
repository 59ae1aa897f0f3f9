// Random numbers that are the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace symplant::test {

/// A number below `end`.
inline std::uint32_t draw(std::mt19937& random, std::uint32_t end) {
  return static_cast<std::uint32_t>(random()) % end;
}

}  // namespace symplant::test
