// Rows of a file of links.
#pragma once

#include <string>
#include <string_view>

#include "name/naming.hpp"

namespace symplant::convert {

/// The first row of a file of links, with its line end.
inline constexpr std::string_view kLinksHeader = "operation,event,state\n";

/// A link as a row that naming::read_links_file() reads, with its line end.
std::string link_row(const name::NamedLink& link);

/// A text for a comment: a line end in a name would end the comment.
std::string on_one_line(std::string text);

}  // namespace symplant::convert
