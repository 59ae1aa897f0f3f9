// The file of `convert --renames`: other names for symbols.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file_system.hpp"
#include "base/result.hpp"
#include "convert/symbols.hpp"

namespace symplant::app {

/// The symbols with the names of a CSV with the columns `old` and `new`; other columns are ignored. On error, the
/// messages, each with file and line: a missing column, an empty or repeated name, an old name that no row has, or a
/// new name that another row has. O(rows + renames).
base::Result<std::shared_ptr<const convert::Symbols>, std::vector<std::string>> rename_symbols(
    const convert::Symbols& symbols, const std::string& file, const base::FileSystem& files);

}  // namespace symplant::app
