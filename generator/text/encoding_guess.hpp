// Which code page a text is likely to be in: a proposal for people, never a decision.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/encoding.hpp"

namespace symplant::text {

/// The beginning of a text, short enough for a message.
std::string as_sample(std::string_view utf8);

/// At most two encodings that can read all of `bytes`, and in which what is not ASCII looks like a language, the
/// likeliest first; the second only where it is nearly as likely and reads the place differently. `offset` is the place
/// that the samples show: the word around it. `tried` is none of them. Reads 64 KiB of words to judge, and all bytes
/// once for each proposal.
std::vector<EncodingGuess> guess_encoding(std::string_view bytes, std::size_t offset, Encoding tried);

/// Those of the usual code pages that can read all of `bytes`. Reads all bytes once for each.
std::vector<UsualEncoding> possible_encodings(std::string_view bytes);

}  // namespace symplant::text
