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
  bool program;         ///< located variables are those of a program; else in global variable lists
};

/// The first is the default.
std::span<const Dialect> dialects();

/// Null for an unknown name.
const Dialect* find_dialect(std::string_view name);

}  // namespace symplant::convert
