// Types and initial values as IEC 61131-3 and TIA Portal write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "convert/symbols.hpp"

namespace symplant::convert {

/// The type of a symbol in IEC 61131-3: an elementary type, a string, or an array of them. If the row has no type, by
/// the size of the address. Nothing for other types: structures, function blocks, timers of a vendor.
std::optional<std::string> iec_type(const Symbol& symbol);

/// The type as a tag of TIA Portal can have it: an elementary one, or that of a SIMATIC list with a `%` address.
/// Nothing for arrays, strings, blocks and types of other vendors.
std::optional<std::string> tia_type(const Symbol& symbol);

/// An initial value as a literal of IEC 61131-3: K5, H1F and 1 of a BOOL are 5, 16#1F and TRUE. Nothing if it is not
/// a value of the type; such text is never written, because it could be anything. Empty if there is no value.
std::optional<std::string> iec_literal(std::string_view initial, std::string_view iec_type);

/// The parts of an array type: ARRAY [0..7, 1..2] OF BOOL.
struct ArrayType {
  std::string_view bounds;   ///< what is in the brackets
  std::string_view element;  ///< the type of an element
};
std::optional<ArrayType> array_type(std::string_view type);

/// The length of STRING[20] or STRING(20), as it is written; empty without a length.
std::string_view string_length(std::string_view type);

}  // namespace symplant::convert
