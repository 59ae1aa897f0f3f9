// Splits texts of the table into words and bytes.
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

/// The size of each table of a server: coils, discrete inputs, holding and input registers.
using Sizes = std::array<std::uint32_t, 4>;

std::vector<std::string> words(const std::string& text);
/// The parts between separators, trimmed of blanks.
std::vector<std::string> split(const std::string& text, std::string_view separator);

/// `{C-1}` or a decimal number.
std::uint32_t address_of(const std::string& word, const Sizes& sizes);

/// A PDU to send, or the pattern that an answer must match.
struct Pattern {
  std::vector<std::optional<std::uint8_t>> bytes;  ///< empty: any byte
  bool objects = false;                            ///< objects of 43/14 follow the bytes, to the end

  bool matches(const Bytes& pdu) const;
  /// Throws std::runtime_error if the pattern is not plain bytes.
  Bytes plain() const;
};

/// Throws std::runtime_error if the text does not match the format in expectations.txt.
Pattern pattern(const std::string& text, const Sizes& sizes);

/// "83 02", cut after a few bytes.
std::string hex(const Bytes& bytes);

}  // namespace symplant::conformance
