// Decodes legacy code pages.
#include "text/code_page.hpp"

#include "text/converter.hpp"

namespace symplant::text {
namespace {

/// The number of bytes at the beginning that belong together: a lead byte and its trail bytes.
std::size_t fault_length(std::string_view bytes, Encoding encoding) {
  const bool two = encoding == Encoding::cp932 || encoding == Encoding::cp949 || encoding == Encoding::gb18030 ||
                   encoding == Encoding::cp950;
  const bool more = two && bytes.size() > 1 && static_cast<unsigned char>(bytes[1]) >= 0x30;
  return more ? 2 : 1;
}

}  // namespace

bool is_code_page(Encoding encoding) { return encoding > Encoding::utf16be; }

base::Result<std::string, CodePageFault> decode_code_page(std::string_view bytes, Encoding encoding) {
  if (!can_convert(encoding)) return CodePageFault{{}, 0, 0};
  std::string_view rest;
  std::string text = convert(encoding, bytes, rest);
  if (rest.empty()) return base::Result<std::string, CodePageFault>(std::move(text));
  return CodePageFault{std::move(text), bytes.size() - rest.size(), fault_length(rest, encoding)};
}

}  // namespace symplant::text
