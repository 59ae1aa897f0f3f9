// The text of a file of another tool.
#include "recording/decoding.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>

#include "text/encoding.hpp"

namespace symplant::recording {
namespace {

/// The bytes of the character at the end of UTF-8 that are there, if some are missing.
std::size_t cut_off_bytes(std::string_view bytes) {
  for (std::size_t there = 1; there <= 3 && there <= bytes.size(); ++there) {
    const auto byte = static_cast<unsigned char>(bytes[bytes.size() - there]);
    if (byte >= 0xC0) {
      const std::size_t whole = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
      return there < whole ? there : 0;
    }
    if (byte < 0x80) break;
  }
  return 0;
}

bool is_utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

}  // namespace

base::Result<std::string, DecodingError> decoded(std::string bytes, const std::string& name,
                                                 std::vector<std::string>& warnings) {
  if (is_utf16(bytes)) {
    bytes.resize(bytes.size() - bytes.size() % 2);
  } else if (const std::size_t cut_off = cut_off_bytes(bytes); cut_off != 0) {
    bytes.replace(bytes.size() - cut_off, cut_off, "?");
  }
  auto text = text::decode(std::move(bytes));
  if (text) return std::move(text->text);
  const text::DecodeError& fault = text.error();
  if (!fault.guesses.empty()) {
    const text::Encoding guess = fault.guesses.front().encoding;
    // NOLINTNEXTLINE(bugprone-use-after-move): decode() leaves the bytes as they are after an error
    if (auto guessed = text::decode(std::move(bytes), &guess)) {
      warnings.push_back(fmt::format("{}:{}:{}: the file is read as {}; if names are wrong, save it as UTF-8", name,
                                     fault.line, fault.column, text::encoding_name(guess)));
      return std::move(guessed->text);
    }
  }
  return DecodingError{fmt::format("{}:{}:{}: {}; save it as UTF-8", name, fault.line, fault.column, fault.what)};
}

}  // namespace symplant::recording
