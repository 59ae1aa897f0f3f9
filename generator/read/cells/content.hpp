// Finds columns by the content of their cells.
#pragma once

#include <optional>
#include <vector>

#include "read/cells/columns.hpp"

namespace symplant::read {

/// Without a header, in a list with a class column: identifiers next to the class, the others by their cells.
Columns classed_columns(const std::vector<CsvRow>& rows);

/// Adds to `columns` what is missing of identifiers, addresses, types and comments, as the cells show it. If two
/// columns serve equally well, neither is taken, and both are returned.
std::optional<Rivals> complete_by_content(const std::vector<CsvRow>& rows, Columns& columns);

/// The better one of two columns for a field, by their cells; nothing if they serve equally well.
std::optional<std::size_t> better_by_content(const std::vector<CsvRow>& rows, const Rivals& rivals);

}  // namespace symplant::read
