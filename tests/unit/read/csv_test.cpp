// Rows of delimited text.
#include "read/cells/csv.hpp"

#include "support/catch.hpp"

using symplant::read::CsvReader;
using symplant::read::CsvRow;
using symplant::read::sniff_delimiter;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(std::string_view text, char delimiter = ',') {
  std::deque<std::string> arena;
  CsvReader reader(text, delimiter, arena);
  CsvRow row;
  Rows rows;
  while (reader.next(row)) rows.emplace_back(row.cells.begin(), row.cells.end());
  return rows;
}

}  // namespace

TEST_CASE("Cells are divided by the delimiter and rows by LF, CRLF or CR") {
  CHECK(rows_of("a,b\nc,d\r\ne\rf,") == Rows{{"a", "b"}, {"c", "d"}, {"e"}, {"f", ""}});
  CHECK(rows_of("a;b,c\n", ';') == Rows{{"a", "b,c"}});
  CHECK(rows_of("").empty());
  CHECK(rows_of("\n\n") == Rows{{""}, {""}});
}

TEST_CASE("Blanks around cells are not part of them") {
  CHECK(rows_of("  a \t, b c ,\" d \"  \n") == Rows{{"a", "b c", "d"}});
  CHECK(rows_of(" a \t b \t\t", '\t') == Rows{{"a", "b", "", ""}});
}

TEST_CASE("A quoted cell holds delimiters, line ends and doubled quotes") {
  CHECK(rows_of("\"a,b\",\"c\"\"d\",\"\"\n\"x\r\ny\",\"\"\"\"\n") == Rows{{"a,b", "c\"d", ""}, {"x\r\ny", "\""}});
}

TEST_CASE("A quote inside a cell that does not begin with one is a literal") {
  CHECK(rows_of("5\" pipe,b\"\n") == Rows{{"5\" pipe", "b\""}});
}

TEST_CASE("Lines within quoted cells are counted") {
  std::deque<std::string> arena;
  CsvReader reader("\"a\nb\r\nc\rd\",x\r\ny\n\nz", ',', arena);
  CsvRow row;
  std::vector<std::uint32_t> lines;
  while (reader.next(row)) lines.push_back(row.line);
  CHECK(lines == std::vector<std::uint32_t>{1, 5, 6, 7});
}

TEST_CASE("A row knows its bytes without its line end") {
  std::deque<std::string> arena;
  const std::string_view text = "a,b\r\n c,d \r\n";
  CsvReader reader(text, ',', arena);
  CsvRow row;
  REQUIRE(reader.next(row));
  CHECK(text.substr(row.whole.begin, row.whole.end - row.whole.begin) == "a,b");
  REQUIRE(reader.next(row));
  CHECK(text.substr(row.whole.begin, row.whole.end - row.whole.begin) == " c,d ");
  CHECK_FALSE(reader.next(row));
}

TEST_CASE("Only cells with doubled quotes are copied") {
  std::deque<std::string> arena;
  const std::string_view text = "a,\"b\",\"c\"\"c\"";
  CsvReader reader(text, ',', arena);
  CsvRow row;
  REQUIRE(reader.next(row));
  CHECK(arena.size() == 1);
  CHECK(row.cells[1].data() == text.data() + 3);
  CHECK(row.cells[2].data() == arena[0].data());
}

TEST_CASE("An unclosed quote ends the reading and is reported where it opens") {
  std::deque<std::string> arena;
  CsvReader reader("a,b\nc,\"d\ne,f\n", ',', arena);
  CsvRow row;
  CHECK(reader.next(row));
  CHECK_FALSE(reader.next(row));
  CHECK(reader.unclosed_quote() == 6U);
  CHECK_FALSE(reader.next(row));
}

TEST_CASE("Text after a closing quote is reported with its location, and the cell continues to the delimiter") {
  std::deque<std::string> arena;
  const std::string_view text = "\"a\" b c ,d\n\"e\"  ,f\n";
  CsvReader reader(text, ',', arena);
  CsvRow row;
  REQUIRE(reader.next(row));
  CHECK(row.cells == std::vector<std::string_view>{"a", "d"});
  REQUIRE(row.stray);
  CHECK(text.substr(row.stray->begin, row.stray->end - row.stray->begin) == "b c");
  REQUIRE(reader.next(row));
  CHECK_FALSE(row.stray);
}

TEST_CASE("Cells above the limit are skipped, and the next row is found") {
  const std::string many(3000000, ',');
  const Rows rows = rows_of(many + "\nx,y\n");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].size() == symplant::read::kMaxCells);
  CHECK(rows[1] == std::vector<std::string>{"x", "y"});
}

TEST_CASE("Long cells of one kind of character are scanned only once") {
  const std::size_t size = 3000000;
  for (const char c : {'x', '"', ' ', ',', '\r'}) {
    const std::string text = "a," + std::string(size, c);
    CHECK_FALSE(rows_of(text).size() > size);
  }
}

TEST_CASE("The delimiter is the one that divides the first rows evenly") {
  CHECK(sniff_delimiter("a,b,c\nd,e,f\n") == ',');
  CHECK(sniff_delimiter("a;b;c, d\ne;f;g\n") == ';');
  CHECK(sniff_delimiter("a\tb\tx, y; z\nc\td\te\n") == '\t');
  CHECK(sniff_delimiter("\"a;b;c\",d\n\"e;f;g\",h\n") == ',');
  CHECK(sniff_delimiter("a, b\nA;ARRAY [0..1, 0..2];x\nB;ARRAY [0..1, 0..2];x\nC;BOOL;x\n") == ';');
  CHECK(sniff_delimiter("abc\n") == ',');
}
