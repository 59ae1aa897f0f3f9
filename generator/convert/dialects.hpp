// The tools for which declarations are written.
#pragma once

#include <span>
#include <string_view>

#include "convert/addresses.hpp"

namespace symplant::convert {

struct Dialect {
  std::string_view name;   ///< for --dialect: "codesys"
  std::string_view title;  ///< "CODESYS"
  AddressForm addresses;
  bool open_addresses;  ///< AT %I*: the tool finds the address
  /// Variables are those of a program, located ones apart from others; else they are global. The compiler has
  /// only the types of the standard's second edition, and addresses only for types of the same size.
  bool program;
};

/// The first is the default.
std::span<const Dialect> dialects();

/// Null for an unknown name.
const Dialect* find_dialect(std::string_view name);

}  // namespace symplant::convert
