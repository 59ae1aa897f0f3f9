// Texts of the table cut into words and bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/raw_client.hpp"

namespace symplant::conformance {

using test::Bytes;

/// How many places each table of a server has: coils, discrete inputs, holding and input registers.
using Sizes = std::array<std::uint32_t, 4>;

std::vector<std::string> words(const std::string& text);
/// The parts between separators, without blanks at their ends.
std::vector<std::string> split(const std::string& text, std::string_view separator);

/// `{C-1}` or a decimal number.
std::uint32_t place(const std::string& word, const Sizes& sizes);

/// A PDU to send, or what one must be like.
struct Pattern {
  std::vector<std::optional<std::uint8_t>> bytes;  ///< nothing: any byte
  bool objects = false;                            ///< behind the bytes come objects of 43/14, to the end

  bool matches(const Bytes& pdu) const;
  /// Throws std::runtime_error where it is not plain bytes.
  Bytes plain() const;
};

/// Throws std::runtime_error where the text is not written as expectations.txt tells.
Pattern pattern(const std::string& text, const Sizes& sizes);

/// "83 02", cut after a few bytes.
std::string hex(const Bytes& bytes);

}  // namespace symplant::conformance
