// From the bytes of a file to its text: encodings, workbooks, files that are known and not read.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diag/diagnostic.hpp"
#include "read/reader.hpp"

namespace symplant::read {

/// A text in which a list may be: that of the file, or of one sheet of a workbook.
struct LoadedText {
  std::shared_ptr<const text::SourceFile> source;
  std::string sheet;                   ///< its name; empty: the file is a text
  std::vector<std::string> decisions;  ///< for --verbose
};

/// The texts of a file, one for each sheet of a workbook; empty if an error was added. O(bytes).
std::vector<LoadedText> load_texts(const std::string& path, std::string bytes, const ReadOptions& options,
                                   diag::Diagnostics& diagnostics);

/// A location in a file whose text cannot be shown.
diag::Location whole_file(const std::string& path);

/// The text of the bytes of a file that is not a list. Returns nothing if it added an error, which ends with `remedy`.
std::optional<text::Decoded> decode_file(const std::string& path, std::string bytes, diag::Diagnostics& diagnostics,
                                         std::string_view remedy);

}  // namespace symplant::read
