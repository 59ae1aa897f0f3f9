// Recognizes the code page of a text, or proposes some.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/encoding_names.hpp"

namespace symplant::text {

/// A likely code page of a text, and the word with the fault as it reads in that code page.
struct EncodingGuess {
  Encoding encoding;
  std::string sample;       ///< UTF-8, short
  bool recognized = false;  ///< by its words, not only possible
};

/// The beginning of a text, short enough for a message.
std::string as_sample(std::string_view utf8);

/// At most five code pages that can decode all of `bytes`, the likeliest first. The code page that libuchardet
/// recognizes is the first, and with enough words the only one. The others are in a fixed order; of several that read
/// the word at `offset` in the same way, only the first is listed. Judges 64 KiB of words at most, and decodes all
/// bytes once for each proposal.
std::vector<EncodingGuess> guess_encoding(std::string_view bytes, std::size_t offset);

}  // namespace symplant::text
