// Fields of requests and replies in either code: numbers, devices, words, bits (sections 1.3, 1.5 and 1.7).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "support/slmp/plc_frames.hpp"

namespace symplant::test::slmp {

/// Reads fields one after the other. A field that does not exist or is not hex reads as 0 and sets `is_short()` or
/// `is_malformed()`.
class FieldReader {
 public:
  FieldReader(std::span<const std::uint8_t> bytes, Code code) : rest_(bytes), code_(code) {}

  /// A number of 1, 2 or 4 bytes; in ASCII of 2, 4 or 8 hex digits.
  std::uint32_t number(std::size_t bytes);
  /// A number of 4 digits whose bytes are in the order of the wire in both codes: the subheader.
  std::uint32_t subheader();
  /// `digits` characters in the base; leading blanks count as zeros. Only for ASCII.
  std::uint32_t digits(std::size_t digits, unsigned base);
  /// Values of points in bit units: a nibble each, in ASCII a character each. Other values than 0 and 1 set
  /// `has_bad_bit()`.
  std::vector<std::uint32_t> bits(std::size_t count);
  std::string text(std::size_t characters);
  void mark_bad_bit() { has_bad_bit_ = true; }

  std::size_t left() const { return rest_.size(); }
  std::span<const std::uint8_t> rest() const { return rest_; }
  Code code() const { return code_; }
  bool is_short() const { return is_short_; }
  bool is_malformed() const { return is_malformed_; }
  bool has_bad_bit() const { return has_bad_bit_; }

 private:
  std::span<const std::uint8_t> take(std::size_t size);

  std::span<const std::uint8_t> rest_;
  Code code_;
  bool is_short_ = false;
  bool is_malformed_ = false;
  bool has_bad_bit_ = false;
};

/// Writes what FieldReader reads.
class FieldWriter {
 public:
  explicit FieldWriter(Code code) : code_(code) {}

  void number(std::uint32_t value, std::size_t bytes);
  void subheader(std::uint32_t value);
  void words(const std::vector<std::uint32_t>& values);
  void dwords(const std::vector<std::uint32_t>& values);
  /// With a nibble of 0 at the end of an odd count in binary.
  void bits(const std::vector<std::uint32_t>& values);
  void text(std::string_view characters);
  void raw(const Bytes& bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  const Bytes& bytes() const { return bytes_; }

 private:
  Code code_;
  Bytes bytes_;
};

}  // namespace symplant::test::slmp
