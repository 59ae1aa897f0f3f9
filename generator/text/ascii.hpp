// Compares texts without regard to ASCII case, as PLC tools compare names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>

#include "base/words.hpp"

namespace symplant::text {

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Eight characters with capitals for small letters.
constexpr std::uint64_t upper_word(std::uint64_t word) {
  const std::uint64_t low = word & ~base::kHighBits;
  const std::uint64_t from_a = low + base::spread(0x80 - 'a');
  const std::uint64_t beyond_z = low + base::spread(0x80 - 'z' - 1);
  return word - ((from_a & ~beyond_z & ~word & base::kHighBits) >> 2U);  // 0x80 of a small letter to its 0x20
}

constexpr bool equal_ignoring_case(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  std::size_t at = 0;
  while (!std::is_constant_evaluated() && a.size() - at >= 8) {
    if (upper_word(base::load_word(a.data() + at)) != upper_word(base::load_word(b.data() + at))) return false;
    at += 8;
  }
  for (; at < a.size(); ++at) {
    if (upper(a[at]) != upper(b[at])) return false;
  }
  return true;
}

inline std::string to_upper(std::string_view text) {
  std::string result(text);
  std::size_t at = 0;
  for (; result.size() - at >= 8; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, result.data() + at, sizeof word);
    word = upper_word(word);
    std::memcpy(result.data() + at, &word, sizeof word);
  }
  for (; at < result.size(); ++at) result[at] = upper(result[at]);
  return result;
}

inline std::string to_lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower(c);
  return result;
}

/// Equal for texts that are equal without regard to case. Hashes eight bytes at a time.
inline std::uint64_t hash_ignoring_case(std::string_view text) {
  // Bit 0x20 separates capital and small letters; other characters that it makes equal only collide in the hash.
  constexpr std::uint64_t kSmall = 0x2020'2020'2020'2020;
  constexpr std::uint64_t kFactor = 0x9FB2'1C65'1E98'DF25;
  std::uint64_t hash = text.size() * kFactor;
  const auto mix = [&](std::uint64_t word) {
    hash = (hash ^ (word | kSmall)) * kFactor;
    hash ^= hash >> 32U;
  };
  std::size_t at = 0;
  for (; text.size() - at >= 8; at += 8) mix(base::load_word(text.data() + at));
  if (at != 0 && at != text.size()) {
    mix(base::load_word(text.data() + text.size() - 8));
  } else if (at == 0) {
    std::uint64_t word = 0;
    for (const char c : text) word = word << 8U | static_cast<unsigned char>(c);
    mix(word);
  }
  return hash;
}

/// For hash maps whose keys compare without regard to case.
struct HashIgnoringCase {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return static_cast<std::size_t>(hash_ignoring_case(text)); }
};
struct EqualIgnoringCase {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const { return equal_ignoring_case(a, b); }
};

/// Values by name. The names are views: their texts must outlive the map.
template <class Value>
using ByName = std::unordered_map<std::string_view, Value, HashIgnoringCase, EqualIgnoringCase>;

}  // namespace symplant::text
