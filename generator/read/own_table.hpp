// The columns of the table that symplant writes, for its writer and its reader.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "address/notation.hpp"

namespace symplant::read {

/// The first columns, in this order. `Direction`, `Scope`, `Class` and `Notation` may follow.
inline constexpr std::array<std::string_view, 5> kOwnColumns{"Name", "Address", "Type", "Initial", "Comment"};

/// The column that names the notation of the addresses, where they do not show it.
inline constexpr std::string_view kNotationColumn = "Notation";
/// In the order of address::Notation.
inline constexpr std::array<std::string_view, 6> kNotationNames{"iec",      "melsec", "siemens",
                                                                "rockwell", "omron",  "modbus"};

/// The notation of the addresses, as the first of them show it.
class OwnNotation {
 public:
  /// Empty cells do not count.
  void add(std::string_view address) {
    if (!address.empty() && !is_full()) cells_.push_back(address);
  }
  bool is_full() const { return cells_.size() == kMostCells; }
  address::Notation notation() const { return address::likely_notation(cells_).value_or(address::Notation::iec); }

 private:
  static constexpr std::size_t kMostCells = 1000;

  std::vector<std::string_view> cells_;
};

}  // namespace symplant::read
