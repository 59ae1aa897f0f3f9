// Converts code pages by Windows, one character at a time.
//
// Differences from iconv of glibc: Hebrew points (cp1255) and Vietnamese tones (cp1258) stay characters that follow a
// letter, which normal form C makes equal; the byte CA of cp1255 is U+05BA, which glibc does not know.
#include "text/converter.hpp"

#include <windows.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "text/utf8.hpp"

namespace symplant::text {
namespace {

constexpr unsigned kShiftJis = 932;
constexpr unsigned kGb18030 = 54936;

unsigned code_page(Encoding encoding) {
  if (encoding == Encoding::gb18030) return kGb18030;
  const std::string_view digits = encoding_name(encoding).substr(2);  // cp1252
  unsigned number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// How many bytes the character at the beginning has, if they are valid.
std::size_t length(unsigned page, bool of_one_byte, std::string_view bytes) {
  if (of_one_byte || bytes.size() < 2) return 1;
  if (page == kGb18030) {
    if (bytes[0] == '\x80' || bytes[0] == '\xFF') return 1;
    return bytes[1] >= '0' && bytes[1] <= '9' ? 4 : 2;
  }
  return IsDBCSLeadByteEx(page, static_cast<BYTE>(bytes[0])) != 0 ? 2 : 1;
}

class Page {
 public:
  explicit Page(Encoding encoding) : number_(code_page(encoding)) {
    CPINFO about{};
    is_known_ = IsValidCodePage(number_) != 0 && GetCPInfo(number_, &about) != 0;
    of_one_byte_ = about.MaxCharSize == 1;
  }

  bool is_known() const { return is_known_; }

  /// Appends the character at the beginning of `rest` and removes it there; false if its bytes are invalid.
  bool take(std::string_view& rest, std::string& text) const {
    const std::size_t size = length(number_, of_one_byte_, rest);
    if (size > rest.size()) return false;
    std::array<wchar_t, 4> units{};
    const int count = MultiByteToWideChar(number_, MB_ERR_INVALID_CHARS, rest.data(), static_cast<int>(size),
                                          units.data(), static_cast<int>(units.size()));
    if (count < 1 || is_unassigned(units[0], size)) return false;
    char32_t character = units[0];
    if (count == 2) character = 0x10000 + ((units[0] - 0xD800U) << 10U) + (units[1] - 0xDC00U);
    append_utf8(text, character);
    rest.remove_prefix(size);
    return true;
  }

 private:
  /// Windows gives bytes without a meaning control characters, characters for private use, and the byte A0 of cp932 a
  /// blank. In two bytes, cp932 and GB 18030 have characters for private use.
  bool is_unassigned(wchar_t unit, std::size_t bytes) const {
    if (unit >= 0x80 && unit < 0xA0) return true;
    const bool is_private = unit >= 0xE000 && unit < 0xF900;
    if (bytes == 1) return is_private || (unit == 0xA0 && !of_one_byte_);
    return is_private && number_ != kShiftJis && number_ != kGb18030;
  }

  unsigned number_;
  bool is_known_ = false;
  bool of_one_byte_ = false;
};

}  // namespace

bool can_convert(Encoding encoding) { return Page(encoding).is_known(); }

std::string convert(Encoding encoding, std::string_view bytes, std::string_view& rest) {
  const Page page(encoding);
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 4 + 16);
  for (rest = bytes; !rest.empty();) {
    const auto other =
        std::find_if(rest.begin(), rest.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    const auto plain = static_cast<std::size_t>(other - rest.begin());
    text.append(rest.substr(0, plain));
    rest.remove_prefix(plain);
    if (!rest.empty() && !page.take(rest, text)) break;
  }
  return text;
}

}  // namespace symplant::text
