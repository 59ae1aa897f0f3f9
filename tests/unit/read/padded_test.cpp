// Cells of fixed width and cells whose quotes are not escaped.
#include "read/cells/padded.hpp"

#include "read/cells/lines.hpp"
#include "read/rockwell/text.hpp"
#include "support/catch.hpp"

using namespace symplant;
using namespace std::string_literals;

TEST_CASE("Columns are cut by characters, and wide characters have two") {
  std::string_view text = "F\xC3\xBChler  I 0.0\xE6\xB3\xB5  end";
  CHECK(read::cut_columns(text, 8) == "F\xC3\xBChler");
  CHECK(read::cut_columns(text, 5) == "I 0.0");
  CHECK(read::cut_columns(text, 2) == "\xE6\xB3\xB5");
  CHECK(read::cut_columns(text, 80) == "end");
  CHECK(read::cut_columns(text, 80).empty());
}

TEST_CASE("A line of quoted cells is split from both ends, so that one cell may have quotes") {
  std::vector<std::string_view> cells;
  REQUIRE(read::split_quoted(R"("a","b","c "d","e" f","","True")", 2, 2, cells));
  CHECK(cells == std::vector<std::string_view>{"a", "b", R"(c "d","e" f)", "", "True"});
  CHECK_FALSE(read::split_quoted(R"("a","b")", 2, 0, cells));
  CHECK_FALSE(read::split_quoted(R"("a","b","c","d)", 2, 0, cells));
  CHECK_FALSE(read::split_quoted(R"(")", 0, 0, cells));
  CHECK_FALSE(read::split_quoted("", 0, 0, cells));
}

TEST_CASE("Lines end at LF, CRLF or CR, and there is none after the last line end") {
  const std::string_view text = "a\r\nb\rc\n\nd";
  read::LineReader lines(text);
  read::Line line;
  std::string all;
  while (lines.next(line)) all += std::to_string(line.number) + std::string(line.text) + " ";
  CHECK(all == "1a 2b 3c 4 5d ");
  read::LineReader ended("a\n");
  CHECK(ended.next(line));
  CHECK_FALSE(ended.next(line));
}

TEST_CASE("Texts of Logix exports are decoded") {
  const auto decode = [](std::string_view text) { return read::decode_rockwell_text(text); };
  CHECK(decode("$D55C$AE00A") ==
        "\xED\x95\x9C\xEA\xB8\x80"
        "A");
  CHECK(decode("a$Nb$Lc$Rd$R$Le$Pf$Tg") == "a\nb\nc\nd\ne\nf\tg");
  CHECK(decode("a$R$L$Lb$lc$nd") == "a\n\nb\nc\nd");
  CHECK(decode("$Qx$Q $'y$' 5$$ $\"") == "\"x\" 'y' 5$ \"");
  CHECK(decode("$D83D$DE00") == "\xF0\x9F\x98\x80");
  CHECK(decode("$D83Dx $DE00") == "\xEF\xBF\xBDx \xEF\xBF\xBD");
  CHECK(decode("a$0000b$0007c$0085d$000De") == "a b c d\ne");
  CHECK(decode("$ZZZZ $x $") == "$ZZZZ $x $");
  CHECK(decode("$$N and $D55") == "$N and $D55");
  CHECK(decode("$N$N text $N").compare("text") == 0);
  CHECK(decode("").empty());
  CHECK(decode("$N").empty());
}
