// The table of encodings and their names.
#include "text/encoding_names.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace symplant::text {
namespace {

/// In the order of Encoding.
constexpr std::array<std::string_view, 21> kNames{
    "utf-8",  "utf-16le", "utf-16be", "cp932",  "cp949",  "gb18030", "cp950", "cp874", "cp1250", "cp1251", "cp1252",
    "cp1253", "cp1254",   "cp1255",   "cp1256", "cp1257", "cp1258",  "cp437", "cp850", "cp852",  "cp866"};
static_assert(kNames.size() == static_cast<std::size_t>(Encoding::cp866) + 1);

struct OtherName {
  std::string_view name;  ///< in lower case, without `-`, `_` and blanks
  Encoding encoding;
};
constexpr std::array kOtherNames{
    OtherName{"utf16", Encoding::utf16le},      OtherName{"unicode", Encoding::utf16le},
    OtherName{"shiftjis", Encoding::cp932},     OtherName{"sjis", Encoding::cp932},
    OtherName{"ms932", Encoding::cp932},        OtherName{"windows31j", Encoding::cp932},
    OtherName{"windows932", Encoding::cp932},   OtherName{"ms949", Encoding::cp949},
    OtherName{"windows949", Encoding::cp949},   OtherName{"uhc", Encoding::cp949},
    OtherName{"euckr", Encoding::cp949},        OtherName{"ksc56011987", Encoding::cp949},
    OtherName{"cp936", Encoding::gb18030},      OtherName{"ms936", Encoding::gb18030},
    OtherName{"windows936", Encoding::gb18030}, OtherName{"gbk", Encoding::gb18030},
    OtherName{"gb2312", Encoding::gb18030},     OtherName{"euccn", Encoding::gb18030},
    OtherName{"cp54936", Encoding::gb18030},    OtherName{"big5", Encoding::cp950},
    OtherName{"ms950", Encoding::cp950},        OtherName{"windows950", Encoding::cp950},
    OtherName{"windows874", Encoding::cp874},   OtherName{"tis620", Encoding::cp874},
    OtherName{"windows1250", Encoding::cp1250}, OtherName{"windows1251", Encoding::cp1251},
    OtherName{"windows1252", Encoding::cp1252}, OtherName{"ansi", Encoding::cp1252},
    OtherName{"latin1", Encoding::cp1252},      OtherName{"iso88591", Encoding::cp1252},
    OtherName{"windows1253", Encoding::cp1253}, OtherName{"windows1254", Encoding::cp1254},
    OtherName{"latin5", Encoding::cp1254},      OtherName{"iso88599", Encoding::cp1254},
    OtherName{"windows1255", Encoding::cp1255}, OtherName{"windows1256", Encoding::cp1256},
    OtherName{"windows1257", Encoding::cp1257}, OtherName{"windows1258", Encoding::cp1258},
    OtherName{"ibm437", Encoding::cp437},       OtherName{"ibm850", Encoding::cp850},
    OtherName{"ibm852", Encoding::cp852},       OtherName{"ibm866", Encoding::cp866},
};

std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c != '-' && c != '_' && c != ' ') text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

}  // namespace

std::string_view encoding_name(Encoding encoding) { return kNames[static_cast<std::size_t>(encoding)]; }

std::span<const std::string_view> encoding_names() { return kNames; }

std::optional<Encoding> encoding_of_name(std::string_view name) {
  const std::string wanted = plain(name);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (plain(kNames[i]) == wanted) return static_cast<Encoding>(i);
  }
  const auto other =
      std::find_if(kOtherNames.begin(), kOtherNames.end(), [&](const OtherName& each) { return each.name == wanted; });
  return other == kOtherNames.end() ? std::nullopt : std::optional(other->encoding);
}

}  // namespace symplant::text
