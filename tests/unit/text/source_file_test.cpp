// Lines, columns and spans of a text.
#include "text/source_file.hpp"

#include "support/catch.hpp"

using symplant::text::SourceFile;

TEST_CASE("Lines end at LF, CRLF and CR, and the last needs no end") {
  const SourceFile file("list.csv", "a\nbb\r\nccc\rdddddddddd");
  CHECK(file.line_count() == 4);
  CHECK(file.line_at(0) == "a");
  CHECK(file.line_at(2) == "bb");
  CHECK(file.line_at(6) == "ccc");
  CHECK(file.line_at(10) == "dddddddddd");
  CHECK(file.position(2).line == 2);
  CHECK(file.position(6).line == 3);
  CHECK(file.position(12).line == 4);
  CHECK(file.position(12).column == 3);
}

TEST_CASE("A line end belongs to the line that it ends") {
  const SourceFile file("list.csv", "ab\r\ncd\n");
  CHECK(file.position(2).line == 1);
  CHECK(file.position(2).column == 3);
  CHECK(file.line_at(3) == "ab");
  CHECK(file.position(7).line == 3);
  CHECK(file.line_at(7).empty());
}

TEST_CASE("An empty text has one empty line") {
  const SourceFile file("list.csv", "");
  CHECK(file.line_count() == 1);
  CHECK(file.position(0).line == 1);
  CHECK(file.position(0).column == 1);
  CHECK(file.line_at(0).empty());
}

TEST_CASE("Columns count characters and not bytes, and stay within a character") {
  const SourceFile file("list.csv", "\xEC\x9A\xB4\xEC\xA0\x84x");  // two Korean syllables
  CHECK(file.position(3).column == 2);
  CHECK(file.position(4).column == 2);
  CHECK(file.position(6).column == 3);
}

TEST_CASE("An offset after the text is its end") {
  const SourceFile file("list.csv", "abc");
  CHECK(file.position(100).column == 4);
  CHECK(file.line_at(100) == "abc");
}

TEST_CASE("A view into the text has its span, any other the fallback") {
  const SourceFile file("list.csv", "abcdef");
  const auto inside = file.span_of(file.text().substr(2, 3));
  CHECK(inside.begin == 2);
  CHECK(inside.end == 5);
  const auto empty = file.span_of(file.text().substr(6, 0));
  CHECK(empty.begin == 6);
  CHECK(empty.end == 6);
  const std::string elsewhere = "abc";
  CHECK(file.span_of(elsewhere, {1, 4}).end == 4);
  CHECK(file.span_of({}, {1, 4}).begin == 1);
}
