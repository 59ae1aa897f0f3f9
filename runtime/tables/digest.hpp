// FNV-1a, and the digest of a plant's tables.
#pragma once

#include <cstdint>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) over bytes and little-endian fields of fixed width.
class Fnv1a64 {
 public:
  void byte(std::uint8_t value) noexcept { hash_ = (hash_ ^ value) * 0x0000'0100'0000'01B3; }
  void u32(std::uint32_t value) noexcept { fixed(value, 4); }
  void u64(std::uint64_t value) noexcept { fixed(value, 8); }
  void time(Time value) noexcept { u64(static_cast<std::uint64_t>(value)); }
  void text(std::string_view value) noexcept {
    for (const char c : value) byte(static_cast<std::uint8_t>(c));
  }
  std::uint64_t value() const noexcept { return hash_; }

 private:
  void fixed(std::uint64_t value, int bytes) noexcept {
    for (int i = 0; i < bytes; ++i) byte(static_cast<std::uint8_t>(value >> (8 * i)));
  }

  std::uint64_t hash_ = 0xCBF2'9CE4'8422'2325;
};

inline std::uint64_t digest_of(std::string_view bytes) noexcept {
  Fnv1a64 digest;
  digest.text(bytes);
  return digest.value();
}

/// The identity of a plant as one number: the same for equal tables on every machine, different if any row or name
/// differs. The plant's name and its controllers count. The line numbers and file names of the symbol lists, and the
/// distribution of a controller's symbols over lists, do not. O(tables).
std::uint64_t model_hash(const PlantTables& tables) noexcept;

}  // namespace symplant::tables
