// The links of a naming rule as a CSV file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diag/diagnostic.hpp"
#include "name/naming.hpp"
#include "text/source_file.hpp"

namespace symplant::naming {

/// Why a row cannot be used; empty if it can. `first`: no row is above it.
std::string link_fault(const name::NamedLink& link, bool first);

struct LinksFile {
  std::vector<name::NamedLink> links;
  std::vector<text::Span> rows;  ///< one for each link
};

/// Reads a table with the columns `operation`, `event` and `state` in any order, separated by `,`, `;` or TAB. Blank
/// rows and lines that begin with `#` do not count. Adds a finding for each fault. O(text).
LinksFile read_links_file(const std::shared_ptr<const text::SourceFile>& source, diag::Diagnostics& diagnostics);

}  // namespace symplant::naming
