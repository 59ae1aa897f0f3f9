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

/// What a plant is, as one number: the same for equal tables wherever they were made, another as soon as any row or
/// name differs. Lines in the symbol lists, the lists' file names and how a controller's
/// symbols are spread over lists do not count; the plant's name and its controllers do. O(tables).
std::uint64_t model_hash(const PlantTables& tables) noexcept;

}  // namespace symplant::tables
