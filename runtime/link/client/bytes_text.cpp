// The text of bytes that are not a reply of the link's protocol, for messages.
#include "symplant/link/client/bytes_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>

namespace symplant::link::client {

std::string bytes_text(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kMostCharacters = 40;
  constexpr std::size_t kMostBytes = 12;
  constexpr std::size_t kLeastCharacters = 4;
  std::string line;
  for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), kMostCharacters))) {
    if (byte < ' ' || byte >= 0x7F || byte == '`') break;
    line += static_cast<char>(byte);
  }
  const bool ends = line.size() == bytes.size() || line.size() == kMostCharacters || bytes[line.size()] == '\r' ||
                    bytes[line.size()] == '\n';
  if (line.size() >= kLeastCharacters && ends) return "`" + line + "`";
  std::string text = "the bytes";
  for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), kMostBytes))) {
    std::array<char, 4> digits{};
    std::snprintf(digits.data(), digits.size(), " %02X", byte);
    text += digits.data();
  }
  return text + (bytes.size() > kMostBytes ? " ..." : "");
}

}  // namespace symplant::link::client
