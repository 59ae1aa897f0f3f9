// Decodes the bytes of a file to UTF-8.
#include "text/encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/words.hpp"
#include "text/code_page.hpp"
#include "text/utf8.hpp"

namespace symplant::text {

namespace {

struct Mark {
  Encoding encoding;
  std::string_view bytes;
};
/// Byte order marks.
constexpr std::array kMarks{Mark{Encoding::utf8, "\xEF\xBB\xBF"}, Mark{Encoding::utf16le, "\xFF\xFE"},
                            Mark{Encoding::utf16be, "\xFE\xFF"}};

constexpr std::string_view kZipMark = "PK\x03\x04";
constexpr std::size_t kSampleBytes = 64 * 1024;
constexpr std::string_view kExportAsText = "export the list as a text file";
/// Bytes of the faulty line that are shown after the fault.
constexpr std::size_t kShownAfterFault = 400;

/// The result of a decoder that stopped at a fault.
struct Fault {
  std::string before;  ///< the text before the fault, as UTF-8
  std::string after;   ///< the text from the fault on, as UTF-8, cut short
  std::string what;
  std::string remedy = std::string(kExportAsText);
  std::vector<EncodingGuess> guesses = {};
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
  error.remedy = std::move(fault.remedy);
  error.guesses = std::move(fault.guesses);
  error.shown_offset = fault.before.size();
  error.shown = std::move(fault.before);
  error.shown.append(fault.after, 0, fault.after.find_first_of("\r\n"));
  return error;
}

bool is_control(unsigned char c) { return (c < 0x20 && (c < 9 || c > 13)) || c == 0x7F; }

/// The offset of the first control character if the bytes hold too many of them for a text; else npos.
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
  return "found the control character U+" + hex(found, 4) + ", so this is a binary or a damaged file";
}

/// Length of the well-formed UTF-8 that `bytes` begin with.
std::size_t valid_utf8_prefix(std::string_view bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    while (bytes.size() - at >= 8 && (base::load_word(bytes.data() + at) & base::kHighBits) == 0) at += 8;
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

/// Removes one NUL or Ctrl-Z after the last line: some tools end a text as C or DOS do.
void take_off_end_mark(std::string& text) {
  if (text.ends_with(std::string_view("\n\0", 2)) || text.ends_with("\n\x1A")) text.pop_back();
}

/// Where and why bytes are not text in any superset of ASCII; nothing if they may be text.
std::optional<std::pair<std::size_t, std::string>> why_no_text(std::string_view bytes) {
  if (bytes.starts_with(kZipMark)) return std::pair(0, "this is a zip archive (perhaps a workbook), not a text file");
  const std::size_t binary = find_binary(bytes);
  if (binary == std::string::npos) return std::nullopt;
  return std::pair(binary, binary_message(static_cast<unsigned char>(bytes[binary])));
}

/// "the byte E4 is", "the bytes 8C 20 are".
std::string bytes_are(std::string_view bytes) {
  std::string text = bytes.size() == 1 ? "the byte" : "the bytes";
  for (const char c : bytes) text += " " + hex(static_cast<unsigned char>(c), 2);
  return text + (bytes.size() == 1 ? " is" : " are");
}

/// Whether the bytes begin with half of a surrogate pair, encoded as a character is.
bool is_surrogate(std::string_view bytes) {
  return bytes.size() >= 3 && bytes[0] == '\xED' && (static_cast<unsigned char>(bytes[1]) & 0xE0U) == 0xA0 &&
         (static_cast<unsigned char>(bytes[2]) & 0xC0U) == 0x80;
}

/// Whether well-formed text has enough characters beyond ASCII that it is UTF-8 by intention.
bool is_mostly_utf8(std::string_view text) {
  constexpr std::size_t kEnough = 4;
  std::size_t found = 0;
  for (std::size_t at = 0; at < text.size() && found < kEnough; ++at) {
    found += (static_cast<unsigned char>(text[at]) & 0xC0U) == 0xC0 ? 1U : 0U;
  }
  return found == kEnough;
}

base::Result<std::string, Fault> decode_utf8(std::string& text) {
  take_off_end_mark(text);
  const std::string_view bytes = text;
  const auto fault_at = [&](std::size_t at, std::string what) {
    return Fault{lossy_utf8(bytes.substr(0, at)), lossy_utf8(bytes.substr(at, kShownAfterFault)), std::move(what)};
  };
  if (auto why = why_no_text(bytes)) return fault_at(why->first, std::move(why->second));
  const std::size_t valid = valid_utf8_prefix(bytes);
  if (valid == text.size()) return base::Result<std::string, Fault>(std::move(text));

  constexpr std::size_t kMostReported = 4;
  std::size_t high = 1;
  while (high < std::min(kMostReported, bytes.size() - valid) &&
         static_cast<unsigned char>(bytes[valid + high]) >= 0x80) {
    ++high;
  }
  Fault fault = fault_at(
      valid, bytes_are(bytes.substr(valid, high)) + " not valid UTF-8 here, so the file is in another encoding");
  fault.remedy = "give its `--encoding`, or save it as UTF-8 or UTF-16";
  if (is_surrogate(bytes.substr(valid))) {
    fault.what = "found a lone half of a surrogate pair as UTF-8, so this is a damaged file";
    fault.remedy = std::string(kExportAsText);
    return fault;
  }
  fault.guesses = guess_encoding(bytes, valid);
  if (!fault.guesses.empty() && is_mostly_utf8(bytes.substr(0, valid))) fault.guesses.front().recognized = false;
  return fault;
}

/// Encodings that can decode bytes that are not in the requested code page.
std::vector<EncodingGuess> guess_instead(std::string_view bytes, std::size_t offset) {
  if (valid_utf8_prefix(bytes) != bytes.size()) return guess_encoding(bytes, offset);
  const std::size_t begin = bytes.find_last_of("\n\r\t,;\"", offset) + 1;  // of a cell; 0 if the text begins with it
  const std::size_t end = bytes.find_first_of("\n\r\t,;\"", offset);
  return {{Encoding::utf8, as_sample(bytes.substr(begin, end - begin))}};
}

base::Result<std::string, Fault> decode_legacy(std::string& bytes, Encoding encoding) {
  take_off_end_mark(bytes);
  const std::string name(encoding_name(encoding));
  for (const Mark& mark : kMarks) {
    if (!bytes.starts_with(mark.bytes)) continue;
    std::string remedy = "remove `--encoding ";
    remedy.append(name).append(
        "`, or the list's `encoding` in plant.json; if other lists need it, write `\"encoding\": \"");
    remedy.append(name).append("\"` for each of them in the `symbols` of a plant.json");
    return Fault{
        {}, {}, "the file begins with the byte order mark of " + std::string(encoding_name(mark.encoding)), remedy};
  }
  if (auto why = why_no_text(bytes)) {
    const auto before = decode_code_page(std::string_view(bytes).substr(0, why->first), encoding);
    return Fault{before ? *before : before.error().before, {}, std::move(why->second)};
  }
  auto text = decode_code_page(bytes, encoding);
  if (text) return base::Result<std::string, Fault>(std::move(*text));
  const CodePageFault& found = text.error();
  if (found.length == 0) {
    return Fault{{},
                 {},
                 "this system cannot convert from " + name,
                 "install the character sets of its C library, or save the list as UTF-8"};
  }
  const std::string_view rest = std::string_view(bytes).substr(found.offset);
  return Fault{found.before, lossy_utf8(rest.substr(0, kShownAfterFault)),
               bytes_are(rest.substr(0, found.length)) + " not a character of " + name + " here",
               "give the encoding that the list was saved in, or save it as UTF-8", guess_instead(bytes, found.offset)};
}

class Utf16Decoder {
 public:
  Utf16Decoder(std::string_view bytes, Encoding encoding)
      : bytes_(bytes), high_(encoding == Encoding::utf16be ? 0 : 1) {}

  base::Result<std::string, Fault> decode() {
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
      if (value == 0) return no_utf16(at, "a lone half of a surrogate pair, U+" + hex(unit, 4));
      if (value > 0xFFFF) ++at;
      append_utf8(text_, value);
    }
    text_.append(ascii.data(), filled);
    if (at < units) return fault(at, binary_message(static_cast<unsigned>(unit_at(at))));
    if (bytes_.size() % 2 != 0) return no_utf16(at, "an incomplete character at the end of the file");
    return base::Result<std::string, Fault>(std::move(text_));
  }

 private:
  static bool is_control_unit(char32_t unit) { return unit < 0x80 && is_control(static_cast<unsigned char>(unit)); }

  char32_t unit_at(std::size_t index) const {
    const char32_t high = static_cast<unsigned char>(bytes_[2 * index + high_]);
    const char32_t low = static_cast<unsigned char>(bytes_[2 * index + 1 - high_]);
    return high << 8U | low;
  }

  /// The code point that begins at a unit; 0 if the unit is 0 or begins no code point.
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

  Fault no_utf16(std::size_t at, const std::string& what) {
    Fault result = fault(at, what + ", so this is not UTF-16, or the file is damaged");
    result.remedy = "export it again or give its encoding";
    return result;
  }

  std::string_view bytes_;
  std::size_t high_;  ///< index of the high byte of a unit, 0 or 1
  std::string text_;
};

/// Recognizes UTF-16 without a mark by its zero bytes, every second one: lists are mostly ASCII.
Encoding sniff(std::string_view bytes) {
  for (const Mark& mark : kMarks) {
    if (bytes.starts_with(mark.bytes)) return mark.encoding;
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

}  // namespace

std::optional<Encoding> declared_encoding(std::string_view bytes) {
  if (!bytes.starts_with("<?xml")) return std::nullopt;
  const std::string_view declaration = bytes.substr(0, std::min<std::size_t>(bytes.find("?>"), 256));
  constexpr std::string_view kKey = "encoding";
  const std::size_t key = declaration.find(kKey);
  if (key == std::string_view::npos) return std::nullopt;
  const std::size_t open = declaration.find_first_of("'\"", key + kKey.size());
  if (open == std::string_view::npos) return std::nullopt;
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return std::nullopt;
  return encoding_of_name(declaration.substr(open + 1, close - open - 1));
}

base::Result<Decoded, DecodeError> decode(std::string&& bytes, const Encoding* forced) {
  const Encoding encoding = forced != nullptr ? *forced : sniff(bytes);
  for (const Mark& mark : kMarks) {
    if (mark.encoding == encoding && bytes.starts_with(mark.bytes)) bytes.erase(0, mark.bytes.size());
  }
  auto text = encoding == Encoding::utf8 ? decode_utf8(bytes)
              : is_code_page(encoding)   ? decode_legacy(bytes, encoding)
                                         : Utf16Decoder(bytes, encoding).decode();
  if (!text) return as_error(text.error());
  return Decoded{std::move(*text), encoding};
}

}  // namespace symplant::text
