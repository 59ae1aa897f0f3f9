// Decodes the bytes of a file to UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "text/encoding_guess.hpp"
#include "text/encoding_names.hpp"

namespace symplant::text {

struct DecodeError {
  std::size_t line;    ///< counted from 1
  std::size_t column;  ///< counted from 1, in characters
  std::string what;    ///< the fault, for a message
  std::string remedy;  ///< what to do, for a message without a guess
  /// The text up to the end of the faulty line (cut after some hundred bytes), with U+FFFD for invalid bytes: for
  /// showing the location to the user.
  std::string shown;
  std::size_t shown_offset;  ///< the offset of the fault in `shown`
  /// Encodings that can decode the whole file, the likeliest first. Only a proposal: a wrong guess would spoil names
  /// without notice.
  std::vector<EncodingGuess> guesses = {};
};

struct Decoded {
  std::string text;  ///< UTF-8, without a byte order mark
  Encoding encoding;
};

/// Decodes by `forced` if given, else by the byte order mark, else as UTF-16 if every second byte is mostly zero, else
/// as UTF-8; never by a code page that was not named. Rejects malformed text, lone surrogates, NUL and binary files.
/// O(bytes); UTF-8 is not copied. After an error `bytes` still has its content, without a byte order mark.
base::Result<Decoded, DecodeError> decode(std::string&& bytes, const Encoding* forced = nullptr);

/// The encoding that the declaration of an XML text names (`<?xml version="1.0" encoding="windows-1251"?>`); nothing if
/// there is none, or it is unknown. O(1).
std::optional<Encoding> declared_encoding(std::string_view bytes);

}  // namespace symplant::text
