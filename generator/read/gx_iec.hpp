// Reads global variable lists of GX IEC Developer 7 and of tools with the same columns.
#pragma once

#include <optional>
#include <string_view>

#include "read/reader.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

/// 0 (not such a list) to 100 (certain).
int gx_iec_likelihood(std::string_view text);

/// Class, Identifier, MIT-Addr., IEC-Addr., Type, Initial, Comment in any order, with or without a header; other
/// columns and lines before the header are ignored. The content of an address decides whether it is a MIT or an IEC
/// address, not the header. Returns nothing if it added an error.
std::optional<SymbolTable> read_gx_iec(const Reading& reading);

}  // namespace symplant::read
