// The compressed form of an answer: whether a client accepts it, and how it is made.
#pragma once

#include <string>
#include <string_view>

namespace symplant::panel {

/// Whether a header `Accept-Encoding` allows gzip: by its name or by `*`, with a weight above 0. O(header).
bool accepts_gzip(std::string_view header);

/// `quick` for what is compressed once and sent once, `small` for what is sent often and never changes.
enum class Packing { quick, small };

/// A text as gzip. O(text); throws std::bad_alloc.
std::string gzip(std::string_view text, Packing packing = Packing::quick);

}  // namespace symplant::panel
