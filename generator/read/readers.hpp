// The table of readers, and reading a symbol list of any known format.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/file_system.hpp"
#include "read/reader.hpp"

namespace symplant::read {

std::span<const ReaderInfo* const> readers();

/// Reads a list: file, encoding, kind, rows. Returns nothing if it added an error (file not found, not decodable,
/// unclosed quote, no rows). A fault of a single row is a warning, and the row is left out or kept as it is.
std::optional<SymbolTable> read_symbol_list(const std::string& path, const ReadOptions& options,
                                            const base::FileSystem& files, diag::Diagnostics& diagnostics);
/// The same for a file whose bytes have been read.
std::optional<SymbolTable> read_symbol_list(const std::string& path, std::string bytes, const ReadOptions& options,
                                            diag::Diagnostics& diagnostics);

}  // namespace symplant::read
