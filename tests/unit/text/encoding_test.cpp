// From bytes to UTF-8.
#include "text/encoding.hpp"

#include <string>

#include "support/catch.hpp"
#include "support/strings.hpp"
#include "text/utf8.hpp"

using namespace symplant;
using namespace symplant::text;
using namespace std::string_literals;

namespace {

const std::string kText = "Class;Name\r\nVAR_GLOBAL;\xC3\x84\xEC\x9A\xB4\xF0\x9F\x98\x80\n";

/// Converts UTF-8 to UTF-16, high or low byte first.
std::string utf16(const std::string& text, bool big) {
  std::string bytes;
  const auto unit = [&](char32_t value) {
    const char high = static_cast<char>(static_cast<unsigned char>(value >> 8U));
    const char low = static_cast<char>(static_cast<unsigned char>(value & 0xFFU));
    bytes += big ? high : low;
    bytes += big ? low : high;
  };
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    at += point.length;
    if (point.value > 0xFFFF) {
      unit(0xD800 + ((point.value - 0x10000) >> 10U));
      unit(0xDC00 + ((point.value - 0x10000) & 0x3FFU));
    } else {
      unit(point.value);
    }
  }
  return bytes;
}

void check_decodes(const std::string& bytes, Encoding encoding) {
  const auto decoded = decode(std::string() + bytes);
  REQUIRE(decoded);
  CHECK(decoded->text == kText);
  CHECK(decoded->encoding == encoding);
}

}  // namespace

TEST_CASE("UTF-8 is read with and without a byte order mark") {
  check_decodes(kText, Encoding::utf8);
  check_decodes("\xEF\xBB\xBF" + kText, Encoding::utf8);
}

TEST_CASE("UTF-16 is read in both byte orders, with and without a byte order mark") {
  check_decodes("\xFF\xFE" + utf16(kText, false), Encoding::utf16le);
  check_decodes("\xFE\xFF" + utf16(kText, true), Encoding::utf16be);
  check_decodes(utf16(kText, false), Encoding::utf16le);
  check_decodes(utf16(kText, true), Encoding::utf16be);
}

TEST_CASE("UTF-16 in which only the delimiters are ASCII is still recognized") {
  const std::string korean = "\xEC\x9A\xB4\xEC\xA0\x84,\xEC\x9A\xB4,\xEC\xA0\x84\r\n";
  const auto decoded = decode(std::string() + utf16(korean, false));
  REQUIRE(decoded);
  CHECK(decoded->text == korean);
}

TEST_CASE("A long UTF-16 text is complete across the decoder's blocks") {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += i % 37 == 0 ? "\xC3\x84" : "a";
  const auto decoded = decode(std::string() + "\xFE\xFF" + utf16(text, true));
  REQUIRE(decoded);
  CHECK(decoded->text == text);
}

TEST_CASE("A given encoding overrides the detected one") {
  const Encoding forced = Encoding::utf16be;
  const auto decoded = decode(std::string() + utf16("AB", true), &forced);
  REQUIRE(decoded);
  CHECK(decoded->text == "AB");
  const Encoding wrong = Encoding::utf8;
  CHECK_FALSE(decode(std::string() + utf16("AB", true), &wrong));
}

TEST_CASE("Text in another code page is rejected, with its location and a hint") {
  const auto decoded = decode(std::string() + "abc\nde\xE4xyz\nmore");
  REQUIRE_FALSE(decoded);
  CHECK(decoded.error().line == 2);
  CHECK(decoded.error().column == 3);
  CHECK(test::contains(decoded.error().what, "E4"));
  CHECK(test::contains(decoded.error().remedy, "save it as UTF-8 or UTF-16"));
  CHECK(decoded.error().shown == "abc\nde\xEF\xBF\xBDxyz");
  CHECK(decoded.error().shown_offset == 6);
}

TEST_CASE("Invalid UTF-8 is rejected") {
  const auto bytes = GENERATE(as<std::string>(), "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80",
                              "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\x80", "\xE2\x82", "\xC3", "12345678\xC3");
  CHECK_FALSE(decode(std::string() + "a,b\n" + bytes));
}

TEST_CASE("A NUL character is rejected with its location") {
  const auto decoded = decode(std::string() + "abc,def\r\ng\0h"s);
  REQUIRE_FALSE(decoded);
  CHECK(decoded.error().line == 2);
  CHECK(decoded.error().column == 2);
  CHECK(test::contains(decoded.error().what, "U+0000"));
}

TEST_CASE("One NUL or Ctrl-Z after the last line is accepted as the end mark of some tools") {
  for (const std::string& mark : {"\0"s, "\x1A"s}) {
    const auto decoded = decode(std::string() + "abc\n" + mark);
    REQUIRE(decoded);
    CHECK(decoded->text == "abc\n");
  }
  CHECK_FALSE(decode(std::string() + "abc\0"s));
}

TEST_CASE("A binary file is rejected as such") {
  const auto elf = decode(
      "\x7F"
      "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0>\0\x01\0\0\0"s);
  REQUIRE_FALSE(elf);
  CHECK(test::contains(elf.error().what, "binary"));
  const auto controls = decode(std::string() + "ab\x01\x02\x03\x04xy\x05");
  REQUIRE_FALSE(controls);
  CHECK(controls.error().column == 3);
  const auto zip = decode(std::string() + "PK\x03\x04\x14\0\x06\0"s);
  REQUIRE_FALSE(zip);
  CHECK(test::contains(zip.error().what, "workbook"));
}

TEST_CASE("A stray control character in a long text is accepted") {
  CHECK(decode(std::string(1000, 'a') + "\x07" + std::string(1000, 'b')));
}

TEST_CASE("Invalid UTF-16 is rejected with its location") {
  const auto lone = decode(std::string() + "\xFF\xFE" + utf16("ab\nc", false) + "\x00\xD8"s + utf16("d", false));
  REQUIRE_FALSE(lone);
  CHECK(lone.error().line == 2);
  CHECK(lone.error().column == 2);
  CHECK(test::contains(lone.error().what, "U+D800"));
  CHECK_FALSE(decode(std::string() + "\xFF\xFE" + utf16("ab", false) + "\x00\xDC\x01\xDC"s));
  CHECK_FALSE(decode(std::string() + "\xFF\xFE" + utf16("ab", false) + "\x00\xDC"s));
  CHECK_FALSE(decode(std::string() + "\xFF\xFE" + utf16("ab", false) + "x"));
  CHECK_FALSE(decode(std::string() + "\xFF\xFE" + utf16("ab", false) + "\0\0"s + utf16("c", false)));
}

TEST_CASE("Encodings are known by name") {
  CHECK(encoding_name(Encoding::utf16be) == "utf-16be");
  CHECK(encoding_of_name("UTF-16LE") == Encoding::utf16le);
  CHECK_FALSE(encoding_of_name("latin"));
}
