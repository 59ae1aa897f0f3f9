// Decodes legacy code pages as the system does: by iconv, or by Windows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "text/encoding_names.hpp"

namespace symplant::text {

/// True for all encodings except UTF-8 and UTF-16.
bool is_code_page(Encoding encoding);

/// The first bytes that are invalid in a code page.
struct CodePageFault {
  std::string before;  ///< the text before the fault, as UTF-8
  std::size_t offset;  ///< of the first invalid byte
  std::size_t length;  ///< the number of invalid bytes; 0: this system does not know the code page
};

/// UTF-8 of bytes in a code page; line ends, delimiters and all other ASCII stay as they are. Bytes without a meaning
/// in the code page, and control characters beyond ASCII, are faults. O(bytes), some 250 MB/s.
base::Result<std::string, CodePageFault> decode_code_page(std::string_view bytes, Encoding encoding);

}  // namespace symplant::text
