// The head of an answer: its status line and headers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::panel::web {

struct ResponseHead {
  int status = 200;
  std::string_view content_type;
  std::optional<std::size_t> length = {};  ///< bytes of the body; nothing: the connection ends with it
  bool keep_alive = false;
  bool packed = false;              ///< the body is gzip
  bool by_encoding = false;         ///< whether it is packed depends on `Accept-Encoding`
  std::string_view file_name = {};  ///< the client stores the body under this name; empty: it shows the body
};

/// With the empty line at its end.
std::string text_of(const ResponseHead& head);

}  // namespace symplant::panel::web
