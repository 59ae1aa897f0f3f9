// From the bytes of a file to UTF-8.
#include "base/encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include "base/utf8.hpp"
#include "base/words.hpp"

namespace symplant::base {

namespace {

struct NamedEncoding {
  Encoding encoding;
  std::string_view name;
  std::string_view mark;  ///< its byte order mark
};

constexpr std::array kEncodings{NamedEncoding{Encoding::utf8, "utf-8", "\xEF\xBB\xBF"},
                                NamedEncoding{Encoding::utf16le, "utf-16le", "\xFF\xFE"},
                                NamedEncoding{Encoding::utf16be, "utf-16be", "\xFE\xFF"}};

constexpr std::string_view kZipMark = "PK\x03\x04";
constexpr std::size_t kSampleBytes = 64 * 1024;
/// How much of the faulty line is shown after the fault.
constexpr std::size_t kShownAfterFault = 400;

/// What a decoder hands on where it stops: UTF-8 so far, and where in the bytes the fault is.
struct Fault {
  std::string before;  ///< UTF-8 of all that stands before it
  std::string after;   ///< UTF-8 of what follows it, fault included, cut short
  std::string what;
};

std::string hex(unsigned value, int digits) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "%0*X", digits, value);
  return buffer;
}

std::string lossy_utf8(std::string_view bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const CodePoint point = code_point_at(bytes, at);
    append_utf8(text, point.value);
    at += point.length;
  }
  return text;
}

DecodeError as_error(Fault fault) {
  DecodeError error{};
  std::size_t line_begin = 0;
  error.line = 1;
  for (std::size_t i = 0; i < fault.before.size(); ++i) {
    const char c = fault.before[i];
    const bool first_of_crlf = c == '\r' && i + 1 < fault.before.size() && fault.before[i + 1] == '\n';
    if ((c != '\n' && c != '\r') || first_of_crlf) continue;
    ++error.line;
    line_begin = i + 1;
  }
  error.column = 1 + count_code_points(std::string_view(fault.before).substr(line_begin));
  error.what = std::move(fault.what);
  error.shown_offset = fault.before.size();
  error.shown = std::move(fault.before);
  error.shown.append(fault.after, 0, fault.after.find_first_of("\r\n"));
  return error;
}

bool is_control(unsigned char c) { return (c < 0x20 && (c < 9 || c > 13)) || c == 0x7F; }

/// Where the first of so many control characters stands that the text is none; npos for a text.
std::size_t find_binary(std::string_view text) {
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) return nul;
  const std::string_view sample = text.substr(0, kSampleBytes);
  std::size_t first = std::string_view::npos;
  std::size_t count = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!is_control(static_cast<unsigned char>(sample[i]))) continue;
    if (count++ == 0) first = i;
  }
  return count * 20 > sample.size() ? first : std::string_view::npos;
}

std::string binary_message(unsigned found) {
  return "found the control character U+" + hex(found, 4) +
         ", so this is a binary or a damaged file; export the list as a text file";
}

/// Length of the well-formed UTF-8 that `bytes` begin with.
std::size_t valid_utf8_prefix(std::string_view bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    while (bytes.size() - at >= 8 && (load_word(bytes.data() + at) & kHighBits) == 0) at += 8;
    // Text in another script has few ASCII words: go on character by character until the next one.
    const std::size_t stop = std::min(bytes.size(), at + 32);
    while (at < stop) {
      const CodePoint point = code_point_at(bytes, at);
      if (!point.valid) return at;
      at += point.length;
    }
  }
  return at;
}

Result<std::string, Fault> decode_utf8(std::string text) {
  // Some tools end a text as C or DOS do: with one NUL or Ctrl-Z after its last line.
  if (text.ends_with(std::string_view("\n\0", 2)) || text.ends_with("\n\x1A")) text.pop_back();
  const auto fault_at = [&](std::size_t at, std::string what) {
    const std::string_view bytes = text;
    return Fault{lossy_utf8(bytes.substr(0, at)), lossy_utf8(bytes.substr(at, kShownAfterFault)), std::move(what)};
  };
  if (text.starts_with(kZipMark)) {
    return fault_at(0, "this is a zip archive (a workbook, perhaps), not a text; export the list as a text file");
  }
  const std::size_t binary = find_binary(text);
  if (binary != std::string::npos) return fault_at(binary, binary_message(static_cast<unsigned char>(text[binary])));
  const std::size_t valid = valid_utf8_prefix(text);
  if (valid != text.size()) {
    return fault_at(valid, "the byte " + hex(static_cast<unsigned char>(text[valid]), 2) +
                               " is no UTF-8 here, so the file is in another code page; save it as UTF-8 or UTF-16");
  }
  return Result<std::string, Fault>(std::move(text));
}

class Utf16Decoder {
 public:
  Utf16Decoder(std::string_view bytes, Encoding encoding)
      : bytes_(bytes), high_(encoding == Encoding::utf16be ? 0 : 1) {}

  Result<std::string, Fault> decode() {
    text_.reserve(bytes_.size() / 2 + 16);
    const std::size_t units = bytes_.size() / 2;
    std::array<char, 4096> ascii{};
    std::size_t filled = 0;
    std::size_t controls = 0;
    std::size_t at = 0;
    for (; at < units; ++at) {
      const char32_t unit = unit_at(at);
      if (unit == 0 || (is_control_unit(unit) && ++controls * 20 > units)) break;
      if (unit < 0x80) {
        ascii[filled++] = static_cast<char>(unit);
        if (filled < ascii.size()) continue;
      }
      text_.append(ascii.data(), filled);
      filled = 0;
      if (unit < 0x80) continue;
      const char32_t value = point_at(at);
      if (value == 0) return fault(at, "a lone half of a surrogate pair, U+" + hex(unit, 4) + not_utf16());
      if (value > 0xFFFF) ++at;
      append_utf8(text_, value);
    }
    text_.append(ascii.data(), filled);
    if (at < units) return fault(at, binary_message(static_cast<unsigned>(unit_at(at))));
    if (bytes_.size() % 2 != 0) return fault(at, "half a character at the end of the file" + not_utf16());
    return Result<std::string, Fault>(std::move(text_));
  }

 private:
  static bool is_control_unit(char32_t unit) { return unit < 0x80 && is_control(static_cast<unsigned char>(unit)); }
  static std::string not_utf16() {
    return ", so this is no UTF-16 or a damaged file; export it again or give its encoding";
  }

  char32_t unit_at(std::size_t index) const {
    const char32_t high = static_cast<unsigned char>(bytes_[2 * index + high_]);
    const char32_t low = static_cast<unsigned char>(bytes_[2 * index + 1 - high_]);
    return high << 8U | low;
  }

  /// The code point that begins at a unit that is not 0; 0 where there is none.
  char32_t point_at(std::size_t index) const {
    const char32_t unit = unit_at(index);
    if (unit < 0xD800 || unit > 0xDFFF) return unit;
    if (unit > 0xDBFF || 2 * index + 3 >= bytes_.size()) return 0;
    const char32_t second = unit_at(index + 1);
    if (second < 0xDC00 || second > 0xDFFF) return 0;
    return 0x10000 + ((unit - 0xD800) << 10U) + (second - 0xDC00);
  }

  Fault fault(std::size_t at, std::string what) {
    Fault result{std::move(text_), {}, std::move(what)};
    const std::size_t end = std::min(bytes_.size() / 2, at + kShownAfterFault);
    for (std::size_t i = at; i < end; ++i) {
      const char32_t value = point_at(i);
      append_utf8(result.after, value == 0 && unit_at(i) != 0 ? kReplacementCharacter : value);
      if (value > 0xFFFF) ++i;
    }
    return result;
  }

  std::string_view bytes_;
  std::size_t high_;  ///< which of a unit's two bytes is the high one
  std::string text_;
};

/// UTF-16 without a mark shows in zero bytes that are every second one: lists are full of ASCII.
Encoding sniff(std::string_view bytes) {
  for (const NamedEncoding& each : kEncodings) {
    if (bytes.starts_with(each.mark)) return each.encoding;
  }
  if (bytes.starts_with(kZipMark) || bytes.size() % 2 != 0) return Encoding::utf8;
  const std::string_view sample = bytes.substr(0, kSampleBytes);
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < sample.size(); ++i) zeros[i % 2] += sample[i] == '\0' ? 1U : 0U;
  const auto speaks_for = [&](std::size_t many, std::size_t few) {
    return zeros[many] > 1 && zeros[many] * 8 >= sample.size() && zeros[few] * 8 < zeros[many];
  };
  if (speaks_for(1, 0)) return Encoding::utf16le;
  if (speaks_for(0, 1)) return Encoding::utf16be;
  return Encoding::utf8;
}

const NamedEncoding& row_of(Encoding encoding) {
  return *std::find_if(kEncodings.begin(), kEncodings.end(),
                       [&](const NamedEncoding& each) { return each.encoding == encoding; });
}

}  // namespace

std::string_view encoding_name(Encoding encoding) { return row_of(encoding).name; }

std::optional<Encoding> encoding_of_name(std::string_view name) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const auto same = [&](char a, char b) { return lower(a) == lower(b); };
  for (const NamedEncoding& each : kEncodings) {
    if (std::equal(name.begin(), name.end(), each.name.begin(), each.name.end(), same)) return each.encoding;
  }
  return std::nullopt;
}

Result<Decoded, DecodeError> decode(std::string bytes, const Encoding* forced) {
  const Encoding encoding = forced != nullptr ? *forced : sniff(bytes);
  if (bytes.starts_with(row_of(encoding).mark)) bytes.erase(0, row_of(encoding).mark.size());
  auto text = encoding == Encoding::utf8 ? decode_utf8(std::move(bytes)) : Utf16Decoder(bytes, encoding).decode();
  if (!text) return as_error(text.error());
  return Decoded{std::move(*text), encoding};
}

}  // namespace symplant::base
