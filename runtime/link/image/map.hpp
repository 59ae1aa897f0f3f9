// What a link carries: each symbol and its position in the link's images.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "symplant/link/link_settings.hpp"
#include "symplant/link/status_fields.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::image {

/// A symbol and its position: a bit of a plane of bits, or one of the numbers. Several symbols may have one position.
struct Point {
  std::uint32_t symbol = 0;  ///< in PlantTables::symbols
  Plane plane = Plane::operation_bits;
  std::uint32_t position = 0;
  OnLoss on_loss = OnLoss::hold;  ///< of operations
};

/// The positions that a protocol gives to the symbols of a controller. A position costs a bit, or 8 bytes, so positions
/// are dense where memory and cost count. A protocol with bit addresses uses these as positions, so that a range of
/// addresses stays a range.
struct Map {
  std::vector<Point> points;                   ///< ascending by symbol
  std::array<std::uint32_t, kPlanes> sizes{};  ///< positions of each plane
  std::optional<std::uint32_t> status;         ///< position of the first of the kStatusFields among the event numbers
  std::uint64_t hash = 0;                      ///< digest of the protocol's map, for the status

  std::uint32_t size(Plane plane) const noexcept { return sizes[static_cast<std::size_t>(plane)]; }
};

/// The plane of a symbol.
inline Plane plane_of(const tables::SymbolRow& symbol) noexcept {
  const bool bit = symbol.type() == tables::DataType::boolean;
  if (symbol.direction() == tables::Direction::operation) return bit ? Plane::operation_bits : Plane::operation_numbers;
  return bit ? Plane::event_bits : Plane::event_numbers;
}

}  // namespace symplant::link::image
