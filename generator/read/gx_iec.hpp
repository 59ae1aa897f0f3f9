// GX IEC Developer 7 global variable lists, and the lists of its relatives that share its columns.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "diag/diagnostic.hpp"
#include "read/symbol_table.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

/// 0 (none of these lists) to 100.
int gx_iec_likelihood(std::string_view text);

/// Class, Identifier, MIT-Addr., IEC-Addr., Type, Initial, Comment in any order, with or without a header; further
/// columns and lines before the header are passed over. Which address is whose is told by its content, whatever the
/// header says. Nothing where an error was added.
std::optional<SymbolTable> read_gx_iec(std::shared_ptr<const text::SourceFile> source, diag::Diagnostics& diagnostics);

}  // namespace symplant::read
