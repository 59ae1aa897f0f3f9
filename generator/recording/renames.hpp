// Reads the file of `--rename`: which symbol a name of a recording is.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace symplant::recording {

/// A name in the recording, and the symbol that it is.
using Renames = std::vector<std::pair<std::string, std::string>>;

/// What was read, or why it could not be.
struct ReadRenames {
  Renames renames;
  std::string error;  ///< `FILE:3:2: ...`, with row and column; empty: the whole file could be read
  std::vector<std::string> warnings;
};

/// Reads a table of two columns: the name in the recording, the symbol. Cells are separated by `,`, `;` or TAB. Lines
/// that begin with `#` are comments; a first row whose second cell is `symbol` or `new` is a header. Several names may
/// be one symbol: recordings may have different ones. `name` is that of the file, for messages. O(file).
ReadRenames read_renames(std::string bytes, const std::string& name);

}  // namespace symplant::recording
