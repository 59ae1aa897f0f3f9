// Rows of Logix exports: what becomes a row, which comment it has, and how names of programs are kept apart.
#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;

namespace {

test::Reading read_tags(const std::string& rows) {
  return test::read_text("TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES\n" + rows);
}

const read::ListRow& row_of(const test::Reading& reading, std::string_view name) {
  for (const read::ListRow& row : reading.table->rows) {
    if (row.name == name) return row;
  }
  FAIL("no row `" << name << "`");
  return reading.table->rows.front();
}

}  // namespace

TEST_CASE("An alias takes the comment of its operand if it has none, and wins over it") {
  const test::Reading reading = read_tags(
      "ALIAS,,Bare,\"\",\"\",\"Local:1:I.Data.0\",\"\"\n"
      "ALIAS,,Own,\"own text\",\"\",\"Local:1:I.Data.1\",\"\"\n"
      "COMMENT,,Local:1:I,\"text 0\",\"\",\"LOCAL:1:I.DATA.0\"\n"
      "COMMENT,,Local:1:I,\"text 1\",\"\",\"Local:1:I.Data.1\"\n"
      "COMMENT,,Local:1:I,\"text 2\",\"\",\"Local:1:I.Data.2\"\n");
  REQUIRE(reading.table);
  REQUIRE(reading.table->rows.size() == 3);
  CHECK(row_of(reading, "Bare").comment == "text 0");
  CHECK(row_of(reading, "Own").comment == "own text");
  CHECK(row_of(reading, "Local:1:I.Data.2").comment == "text 2");
}

TEST_CASE("A comment on a word is the comment of the parent of its bits, and no row") {
  const test::Reading reading = read_tags(
      "TAG,,Local:1:I,\"module\",\"AB:1756_DI:I:0\",\"\",\"\"\n"
      "COMMENT,,Local:1:I,\"word\",\"\",\"Local:1:I.Data[2]\"\n"
      "COMMENT,,Local:1:I,\"bit\",\"\",\"Local:1:I.Data[2].3\"\n"
      "COMMENT,,Local:1:I,\"channel\",\"\",\"Local:1:I.Ch0Data\"\n");
  REQUIRE(reading.table);
  REQUIRE(reading.table->rows.size() == 3);
  const auto parent = [&](std::string_view name) {
    return reading.table->extra_of(row_of(reading, name)).parent_comment;
  };
  CHECK(parent("Local:1:I.Data[2].3") == "word");
  CHECK(parent("Local:1:I.Ch0Data") == "module");
  CHECK(row_of(reading, "Local:1:I").vendor_address.empty());
  CHECK(row_of(reading, "Local:1:I").type == "AB:1756_DI:I:0");
}

TEST_CASE("An alias of a word is a structure if its bits are rows") {
  const test::Reading reading = read_tags(
      "ALIAS,,Word,\"\",\"\",\"Local:1:I.Data[2]\",\"\"\n"
      "ALIAS,,Level,\"\",\"\",\"Local:1:I.Data[3]\",\"\"\n"
      "ALIAS,,Card,\"\",\"\",\"Local:1:I\",\"\"\n"
      "COMMENT,,Word,\"bit\",\"\",\"Word.3\"\n");
  REQUIRE(reading.table);
  CHECK(test::rows_as_text(*reading.table) ==
        "|Word|||STRUCTURE||\n"
        "|Level|Local:1:I.Data[3]||||\n"
        "|Card|||STRUCTURE||\n"
        "|Word.3|Local:1:I.Data[2].3||||bit\n");
}

TEST_CASE("A name that several scopes have is kept apart by its program, other names are kept") {
  const test::Reading reading = read_tags(
      "TAG,,Ready,\"\",\"BOOL\",\"\",\"\"\n"
      "TAG,Wash,READY,\"\",\"BOOL\",\"\",\"\"\n"
      "TAG,Wash,Pump,\"\",\"BOOL\",\"\",\"\"\n");
  REQUIRE(reading.table);
  CHECK(test::rows_as_text(*reading.table) ==
        "|Ready|Ready||BOOL||\n"
        "|Wash.READY|\\Wash.READY||BOOL||\n"
        "|Pump|\\Wash.Pump||BOOL||\n");
}

TEST_CASE("An alias that leads to no tag is reported and kept") {
  const test::Reading reading = read_tags(
      "ALIAS,,A,\"\",\"\",\"B\",\"\"\n"
      "ALIAS,,B,\"\",\"\",\"A\",\"\"\n"
      "ALIAS,,C,\"\",\"\",\"Missing.3\",\"\"\n");
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 3);
  REQUIRE(reading.diagnostics.count(diag::Severity::warning) == 3);
  CHECK(test::contains(reading.diagnostics.all()[0].message, "leads back to itself"));
  CHECK(test::contains(reading.diagnostics.all()[2].message, "export that tag too"));
  CHECK(row_of(reading, "C").vendor_address == "Missing.3");
}

TEST_CASE("A tag of a project as text may have forced values behind its value") {
  const test::Reading reading = test::read_text(
      "IE_VER := 2.11;\nCONTROLLER Line (ProcessorType := \"1756-L61\")\n\tTAG\n"
      "\t\tFrom : DINT[2] (Producer := \"PRESS\") := [7,0],\n\t\t\tTagForceData := [1,0,\n\t\t\t0,0];\n"
      "\t\tNext : BOOL := 1, TagForceData := [0], Other := 'x;y';\n\tEND_TAG\nEND_CONTROLLER\n",
      "line.L5K");
  REQUIRE(reading.table);
  CHECK(test::rows_as_text(*reading.table) == "|From|From||DINT[2]||\n|Next|Next||BOOL||\n");
  CHECK(reading.diagnostics.all().empty());
}

TEST_CASE("A project as text and a list as CSV of the same tags give the same rows") {
  const test::Reading csv = read_tags(
      "ALIAS,,Gate,\"open$Nnow\",\"\",\"Local:1:I.Data.0\",\"\"\n"
      "TAG,,Words,\"\",\"DINT[4]\",\"\",\"\"\n"
      "ALIAS,,Bit,\"\",\"\",\"Words[1].2\",\"\"\n"
      "COMMENT,,Words,\"second\",\"\",\"Words[1].2\"\n");
  const test::Reading project = test::read_text(
      "IE_VER := 2.21;\nCONTROLLER C (Major := 30)\n TAG\n"
      "  Gate OF Local:1:I.Data.0 (Description := \"open$Nnow\", RADIX := Decimal);\n"
      "  Words : DINT[4] (COMMENT[1].2 := \"second\",\n RADIX := Binary) := [1,2,3,4];\n"
      "  Bit OF Words[1].2;\n END_TAG\nEND_CONTROLLER\n");
  REQUIRE(csv.table);
  REQUIRE(project.table);
  CHECK(test::rows_as_text(*csv.table) == test::rows_as_text(*project.table));
}
