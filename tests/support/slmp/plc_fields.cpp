// Fields of requests and replies in either code.
#include "support/slmp/plc_fields.hpp"

#include <algorithm>

namespace symplant::test::slmp {
namespace {

/// 16 if the character is not an upper-case hex digit.
std::uint32_t digit_value(std::uint8_t character) {
  if (character >= '0' && character <= '9') return character - std::uint32_t{'0'};
  if (character >= 'A' && character <= 'F') return character - std::uint32_t{'A'} + 10;
  return 16;
}

}  // namespace

std::span<const std::uint8_t> FieldReader::take(std::size_t size) {
  if (size > rest_.size()) {
    is_short_ = true;
    rest_ = {};
    return {};
  }
  const auto taken = rest_.first(size);
  rest_ = rest_.subspan(size);
  return taken;
}

std::uint32_t FieldReader::number(std::size_t bytes) {
  if (code_ == Code::ascii) {
    const bool was_blank = !rest_.empty() && rest_.front() == ' ';
    if (was_blank) is_malformed_ = true;
    return digits(2 * bytes, 16);
  }
  std::uint32_t value = 0;
  unsigned shift = 0;
  for (const std::uint8_t byte : take(bytes)) {
    value |= std::uint32_t{byte} << shift;
    shift += 8;
  }
  return value;
}

std::uint32_t FieldReader::subheader() {
  if (code_ == Code::ascii) return number(2);
  const auto bytes = take(2);
  return bytes.empty() ? 0 : std::uint32_t{bytes[0]} << 8 | bytes[1];
}

std::uint32_t FieldReader::digits(std::size_t digits, unsigned base) {
  std::uint64_t value = 0;
  bool leading = true;
  for (const std::uint8_t character : take(digits)) {
    if (leading && character == ' ') continue;
    leading = false;
    const std::uint32_t digit = digit_value(character);
    if (digit >= base) is_malformed_ = true;
    value = value * base + (digit < base ? digit : 0);
  }
  if (leading && !is_short_) is_malformed_ = true;
  return static_cast<std::uint32_t>(value);
}

std::vector<std::uint32_t> FieldReader::bits(std::size_t count) {
  std::vector<std::uint32_t> values;
  const auto bytes = take(code_ == Code::ascii ? count : (count + 1) / 2);
  if (is_short_) return std::vector<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t value = code_ == Code::ascii ? digit_value(bytes[i])
                                : i % 2 == 0         ? bytes[i / 2] >> 4U
                                                     : bytes[i / 2] & 0xFU;
    if (value > 1) has_bad_bit_ = true;
    values.push_back(value);
  }
  return values;
}

std::string FieldReader::text(std::size_t characters) {
  const auto bytes = take(characters);
  return {bytes.begin(), bytes.end()};
}

void FieldWriter::number(std::uint32_t value, std::size_t bytes) {
  if (code_ == Code::binary) {
    for (std::size_t i = 0; i < bytes; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return;
  }
  for (std::size_t i = 2 * bytes; i > 0; --i) {
    bytes_.push_back(static_cast<std::uint8_t>("0123456789ABCDEF"[value >> (4 * (i - 1)) & 0xFU]));
  }
}

void FieldWriter::subheader(std::uint32_t value) {
  if (code_ == Code::ascii) return number(value, 2);
  bytes_.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes_.push_back(static_cast<std::uint8_t>(value));
}

void FieldWriter::words(const std::vector<std::uint32_t>& values) {
  for (const std::uint32_t value : values) number(value, 2);
}

void FieldWriter::dwords(const std::vector<std::uint32_t>& values) {
  for (const std::uint32_t value : values) number(value, 4);
}

void FieldWriter::bits(const std::vector<std::uint32_t>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (code_ == Code::ascii) {
      bytes_.push_back(values[i] != 0 ? '1' : '0');
    } else if (i % 2 == 0) {
      bytes_.push_back(values[i] != 0 ? 0x10 : 0x00);
    } else if (values[i] != 0) {
      bytes_.back() |= 0x01;
    }
  }
}

void FieldWriter::text(std::string_view characters) {
  for (const char character : characters) bytes_.push_back(static_cast<std::uint8_t>(character));
}

}  // namespace symplant::test::slmp
