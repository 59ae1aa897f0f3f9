// The names that a target gets: changed only where it needs that, and unique.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/index_table.hpp"
#include "convert/report.hpp"
#include "convert/symbols.hpp"

namespace symplant::convert {

/// What a target demands of names, which must differ in more than case.
struct NameRule {
  bool (*accepts)(std::string_view name) = nullptr;
  std::string (*make)(std::string_view name) = nullptr;  ///< an accepted name that reads like this one
  std::size_t longest = 0;                               ///< characters
  Loss renamed;
};

extern const NameRule kIecNames;
extern const NameRule kTiaNames;

class Names {
 public:
  /// Names the symbols with these indexes in `symbols.all`, and reports each change. An accepted name stays with the
  /// first symbol that has it. `symbols` must outlive the names. O(symbols).
  Names(const Symbols& symbols, std::span<const std::uint32_t> written, const NameRule& rule, Report& report);

  /// The name of the symbol with this index in `symbols.all`.
  std::string_view operator[](std::uint32_t index) const;

 private:
  bool take(std::uint32_t index, std::string_view name);
  std::string unique(std::uint32_t index, const NameRule& rule);

  const Symbols& symbols_;
  base::IndexTable by_name_;
  std::unordered_map<std::uint32_t, std::string> changed_;
  std::unordered_map<std::string, std::size_t> next_;  ///< by made name in lower case: the next number to try
};

}  // namespace symplant::convert
