// From the bytes of a file to UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace symplant::base {

enum class Encoding { utf8, utf16le, utf16be };

/// The name that `--encoding` takes: `utf-8`, `utf-16le`, `utf-16be`.
std::string_view encoding_name(Encoding encoding);

/// The encoding of that name, whatever its ASCII case; nothing for an unknown one.
std::optional<Encoding> encoding_of_name(std::string_view name);

struct DecodeError {
  std::size_t line;    ///< counted from 1
  std::size_t column;  ///< counted from 1, in characters
  std::string what;    ///< what is there and what to do, for a message
  /// The text as far as the end of the faulty line (cut after some hundred bytes), U+FFFD for what is no character: for
  /// showing the place to the user.
  std::string shown;
  std::size_t shown_offset;  ///< where the fault stands in `shown`
};

struct Decoded {
  std::string text;  ///< UTF-8, without a byte order mark
  Encoding encoding;
};

/// Decodes by `forced` where it is given, else by the byte order mark, else as UTF-16 where its zero bytes say so, else
/// as UTF-8. Refused: ill-formed UTF-8 and UTF-16, lone surrogates, NUL, a binary file. O(bytes); UTF-8 is not copied.
Result<Decoded, DecodeError> decode(std::string bytes, const Encoding* forced = nullptr);

}  // namespace symplant::base
