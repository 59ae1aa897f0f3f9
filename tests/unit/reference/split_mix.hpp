// The random draws of docs/model.md: a second implementation.
#pragma once

#include <cstdint>
#include <string>

namespace symplant::test {

/// SplitMix64's first output, published as 0xE220A8397B1DCDAF for a start at 0.
inline std::uint64_t split_mix_output(std::uint64_t start) {
  std::uint64_t z = start + 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

inline std::uint64_t fnv_of(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  return hash;
}

}  // namespace symplant::test
