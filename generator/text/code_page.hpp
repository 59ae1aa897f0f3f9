// Texts in legacy code pages, by the system's iconv.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "text/encoding.hpp"

namespace symplant::text {

/// True for all but UTF-8 and UTF-16.
bool is_code_page(Encoding encoding);

/// Where a text stops being one of its code page.
struct CodePageFault {
  std::string before;  ///< UTF-8 of all that stands before it
  std::size_t offset;  ///< of the first byte that is no character
  std::size_t length;  ///< bytes that are none together; 0: this system does not know the code page
};

/// UTF-8 of bytes in a code page; line ends, delimiters and all other ASCII stay as they are. Bytes that the code page
/// gives no meaning to, or that of a control character beyond ASCII, are faults. O(bytes), some 250 MB/s.
base::Result<std::string, CodePageFault> decode_code_page(std::string_view bytes, Encoding encoding);

}  // namespace symplant::text
