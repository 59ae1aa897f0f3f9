// The table of readers, and reading a symbol list of whichever kind.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/file_system.hpp"
#include "diag/diagnostic.hpp"
#include "read/symbol_table.hpp"
#include "text/encoding.hpp"

namespace symplant::read {

/// One kind of export. `likelihood` is 0 (not mine) to 100 (certain); the reader with the highest reads the file.
struct ReaderInfo {
  std::string_view name;   ///< for --input-format: "gx-iec"
  std::string_view title;  ///< "GX IEC Developer 7 global variable list"
  int (*likelihood)(std::string_view text);
  std::optional<SymbolTable> (*read)(std::shared_ptr<const text::SourceFile>, diag::Diagnostics&);
};

std::span<const ReaderInfo> readers();

struct ReadOptions {
  std::string input_format;                ///< empty: sniffed
  std::optional<text::Encoding> encoding;  ///< nothing: sniffed
  bool described = false;                  ///< a plant.json names the list, and may say its encoding
};

/// Reads a list: file, encoding, kind, rows. Gives nothing where an error was added (no such file, not decodable,
/// unclosed quote, a header alone, no rows at all). Faults of a single row are warnings and the row is left out or kept
/// as it is.
std::optional<SymbolTable> read_symbol_list(const std::string& path, const ReadOptions& options,
                                            const base::FileSystem& files, diag::Diagnostics& diagnostics);
/// Likewise of a file whose bytes have been read.
std::optional<SymbolTable> read_symbol_list(const std::string& path, std::string bytes, const ReadOptions& options,
                                            diag::Diagnostics& diagnostics);

/// The text of a file's bytes, and its encoding; nothing where an error was added: with the encodings that it is likely
/// to be in, and how they would read it. `remedy` takes the place of that where the file is no list.
std::optional<text::Decoded> decode_file(const std::string& path, std::string bytes, const ReadOptions& options,
                                         diag::Diagnostics& diagnostics, std::string_view remedy = {});

}  // namespace symplant::read
