// Makes text safe to show.
#include "diag/visible_text.hpp"

#include "support/catch.hpp"

using namespace symplant::diag;

TEST_CASE("Control, bidi and invisible characters are made visible") {
  CHECK(visible("a\x1b[31mb") == "a<U+001B>[31mb");
  CHECK(visible("a\tb\r\n") == "a<U+0009>b<U+000D><U+000A>");
  CHECK(visible("x\xE2\x80\xAE"
                "y") == "x<U+202E>y");
  CHECK(visible("x\xE2\x80\x8B"
                "y") == "x<U+200B>y");
  CHECK(visible("\xC2\x85") == "<U+0085>");
  CHECK(visible(std::string("\0", 1)) == "<U+0000>");
}

TEST_CASE("Ordinary text of any script does not change") {
  const std::string text = "\xC3\x84 \xEC\x9A\xB4\xEC\xA0\x84 \xE6\xBC\xA2";
  CHECK(visible(text) == text);
}

TEST_CASE("Invalid UTF-8 is shown as a replacement character") { CHECK(visible("a\xFF") == "a\xEF\xBF\xBD"); }

TEST_CASE("East Asian characters take two columns and combining marks take zero") {
  CHECK(display_width(U'a') == 1);
  CHECK(display_width(0xC4) == 1);
  CHECK(display_width(0xC6B4) == 2);
  CHECK(display_width(0x6F22) == 2);
  CHECK(display_width(0xFF21) == 2);
  CHECK(display_width(0x301) == 0);
}
