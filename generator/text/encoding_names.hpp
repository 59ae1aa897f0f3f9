// The encodings of lists, and their names.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace symplant::text {

enum class Encoding : std::uint8_t {
  utf8,
  utf16le,
  utf16be,
  cp932,    ///< Japanese: Shift_JIS as Windows has it
  cp949,    ///< Korean: windows-949, that is UHC; EUC-KR is part of it
  gb18030,  ///< simplified Chinese; GBK (cp936) and GB2312 are part of it
  cp950,    ///< traditional Chinese: Big5 as Windows has it
  cp874,    ///< Thai
  cp1250,   ///< Central Europe
  cp1251,   ///< Cyrillic
  cp1252,   ///< Western Europe; ISO 8859-1 is part of it, except for control characters
  cp1253,   ///< Greek
  cp1254,   ///< Turkish
  cp1255,   ///< Hebrew
  cp1256,   ///< Arabic
  cp1257,   ///< Baltic
  cp1258,   ///< Vietnamese
  cp437,    ///< DOS
  cp850,    ///< DOS, Western Europe
  cp852,    ///< DOS, Central Europe
  cp866,    ///< DOS, Cyrillic
};

/// The name that `--encoding` takes: `utf-8`, `cp949`.
std::string_view encoding_name(Encoding encoding);

/// The encoding of that name or another common one (`shift_jis`, `windows-949`, `latin1`); ASCII case, `-`, `_` and
/// blanks are ignored. Nothing for an unknown name.
std::optional<Encoding> encoding_of_name(std::string_view name);

/// All names that encoding_name() returns, in the order of Encoding.
std::span<const std::string_view> encoding_names();

}  // namespace symplant::text
