// Files that symplant writes and a person may edit: a mark in the first line shows whether someone has.
#pragma once

#include <string>
#include <string_view>

namespace symplant::app {

/// The text below a comment that holds its digest.
std::string with_mark(std::string_view text);

/// Whether a file begins with such a comment: symplant wrote it, and a person may have edited it.
bool has_mark(std::string_view file);

/// Whether a file is as with_mark() made it: no one has edited it. O(text).
bool is_unedited(std::string_view file);

}  // namespace symplant::app
