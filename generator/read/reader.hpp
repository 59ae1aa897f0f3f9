// What a reader of a format takes, and its row in the table of readers.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "address/address.hpp"
#include "diag/diagnostic.hpp"
#include "read/cells/column_map.hpp"
#include "read/symbol_table.hpp"
#include "text/encoding.hpp"

namespace symplant::read {

struct ReadOptions {
  std::string input_format = {};                ///< empty: recognized by content
  std::optional<text::Encoding> encoding = {};  ///< nothing: recognized by content
  ColumnMap columns = {};                       ///< what the user says about a table; empty: recognized
  address::IoRanges io_words = {};              ///< which words of CIO are inputs or outputs; empty: none
  std::size_t part = 0;                         ///< of several lists in one text, counted from 1; 0: all rows
  bool described = false;                       ///< a plant.json names the list and may give its encoding
  std::optional<address::Radix> xy = {};        ///< how X and Y count if no row proves it; nothing: hexadecimal
};

/// One list to read: its text, what the user said about it, and where findings go.
struct Reading {
  std::shared_ptr<const text::SourceFile> source;
  const ReadOptions& options;
  diag::Diagnostics& diagnostics;
};

/// One kind of export. `likelihood` is 0 (another format) to 100 (certain); the reader with the highest reads the file.
/// It looks at the beginning of the text only. `read` returns nothing if it added an error.
struct ReaderInfo {
  std::string_view name;   ///< for --input-format: "gx-iec"
  std::string_view title;  ///< "GX IEC Developer 7 global variable list"
  int (*likelihood)(std::string_view text);
  std::optional<SymbolTable> (*read)(const Reading& reading);
};

}  // namespace symplant::read
