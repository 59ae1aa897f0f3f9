// From the bytes of a file to UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

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
  cp1252,   ///< Western Europe; ISO 8859-1 is part of it but for control characters
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

/// The encoding of that name or another common one (`shift_jis`, `windows-949`, `latin1`), whatever its ASCII case,
/// with `-`, `_` and blanks or without; nothing for an unknown one.
std::optional<Encoding> encoding_of_name(std::string_view name);

/// Every name that encoding_name() gives, in the order of Encoding.
std::span<const std::string_view> encoding_names();

/// A code page that a text is likely to be in, and how that would read the place at fault.
struct EncodingGuess {
  Encoding encoding;
  std::string sample;  ///< UTF-8, short
};

/// One of the code pages that most lists in none of Unicode's encodings are in.
struct UsualEncoding {
  Encoding encoding;
  std::string_view where;  ///< "Western Europe"
};

struct DecodeError {
  std::size_t line;    ///< counted from 1
  std::size_t column;  ///< counted from 1, in characters
  std::string what;    ///< what is there, for a message
  std::string remedy;  ///< what to do, for a message; for where no guess is told
  /// The text as far as the end of the faulty line (cut after some hundred bytes), U+FFFD for what is no character: for
  /// showing the place to the user.
  std::string shown;
  std::size_t shown_offset;  ///< where the fault stands in `shown`
  /// At most two, the likeliest first; each of them can read the whole file. A proposal only: what was guessed wrong
  /// would spoil names, and nobody would notice.
  std::vector<EncodingGuess> guesses = {};
  /// Where nothing can be guessed: those of the usual ones that can read the whole file, whatever that comes to.
  std::vector<UsualEncoding> possible = {};
};

struct Decoded {
  std::string text;  ///< UTF-8, without a byte order mark
  Encoding encoding;
};

/// Decodes by `forced` where it is given, else by the byte order mark, else as UTF-16 where its zero bytes say so, else
/// as UTF-8; never by a code page that nobody named. Refused: ill-formed text of the encoding, lone surrogates, NUL, a
/// binary file. O(bytes); UTF-8 is not copied.
base::Result<Decoded, DecodeError> decode(std::string bytes, const Encoding* forced = nullptr);

}  // namespace symplant::text
