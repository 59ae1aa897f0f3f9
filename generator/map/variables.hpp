// The variables by which a PLC's program uses a map: names, types, comments.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "map/link_view.hpp"
#include "symplant/link/status_fields.hpp"

namespace symplant::map {

/// Names of variables: identifiers of IEC 61131-3 that differ in more than case. A symbol keeps its name if it is one
/// and no earlier symbol has it.
class VariableNames {
 public:
  /// O(symbols).
  explicit VariableNames(const LinkView& view);

  const std::string& operator[](std::uint32_t symbol) const { return names_[symbol]; }
  /// Another name: `wanted`, or `wanted` with a number.
  std::string add(const std::string& wanted);

 private:
  bool take(const std::string& name);

  std::vector<std::string> names_;  ///< by symbol; empty: on no link
  std::unordered_set<std::string> taken_;
};

/// "PLANT_LOST_EXCHANGES".
std::string status_name(const link::StatusField& field);

/// The type of an unsigned number of this many words: UINT, UDINT, ULINT.
std::string_view unsigned_type(std::uint32_t words);

/// "input registers 100-101, high word first, inverted; renamed, row 7 of the list": it contains no text of the user.
std::string variable_comment(const LinkView& view, const VariableNames& names, const link::modbus::IoPoint& point);

/// "must be 16#550AC79417AA6039" for the digest, else the meaning of the field.
std::string status_comment(const LinkView& view, const link::StatusField& field);

}  // namespace symplant::map
