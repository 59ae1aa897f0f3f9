// Hostile exports: nothing crashes or hangs, and what can be read is read.
#include "read_support.hpp"

using namespace symplant;
using test::kMany;
using test::read_soon;
using test::repeated;

namespace {

const std::string kCsvHeader = "TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES\n";
const std::string kProject = "IE_VER := 2.21;\nCONTROLLER C (Major := 30)\n TAG\n";

}  // namespace

TEST_CASE("Cycles and chains of 100,000 aliases are read in time") {
  std::string cycle = kCsvHeader;
  std::string chain = kCsvHeader;
  for (int i = 0; i < kMany; ++i) {
    const std::string row = "ALIAS,,T" + std::to_string(i) + ",\"\",\"\",";
    cycle += row + "\"T" + std::to_string((i + 1) % kMany) + "\",\"\"\n";
    chain += row + (i + 1 == kMany ? "\"Local:1:I.Data.0\"" : "\"T" + std::to_string(i + 1) + "\"") + ",\"\"\n";
  }
  const test::Reading around = read_soon(cycle);
  REQUIRE(around.table);
  CHECK(around.table->rows.size() == kMany);
  CHECK(around.diagnostics.count(diag::Severity::warning) == 1001);
  const test::Reading along = read_soon(chain);
  REQUIRE(along.table);
  CHECK(along.table->rows.front().vendor_address == "Local:1:I.Data.0");
  CHECK(along.diagnostics.all().empty());
}

TEST_CASE("Comments of a megabyte are kept, and a parent's is decoded once for all its parts") {
  std::string list = kCsvHeader + "TAG,,Local:1:I,\"" + repeated("$D55C", 200'000) + "\",\"T\",\"\",\"\"\n";
  for (int i = 0; i < 20'000; ++i) {
    list += "ALIAS,,T" + std::to_string(i) + ",\"\",\"\",\"Local:1:I.Data[" + std::to_string(i) + "]\",\"\"\n";
  }
  const test::Reading reading = read_soon(list);
  REQUIRE(reading.table);
  CHECK(reading.table->extra_of(reading.table->rows.back()).parent_comment.size() == 600'000);
  for (const std::string& text :
       {"126," + std::string(46, 'x') + repeated("c", 1 << 20),
        "\"A\",\"%I0.0\",\"Bool\",\"True\",\"True\",\"False\",\"" + repeated("\",\"", 1 << 18) + "\",\"\",\"True\"",
        "CXProgVer:=1;\nVariableList:=\nBEGIN_LIST_$#[5]\nA,1.0,BOOL,,," + repeated(";", 1 << 20),
        kProject + "A : BOOL (Description := \"" + repeated("$$", 1 << 19) + "\");"}) {
    INFO(text.substr(0, 60));
    const test::Reading one = read_soon(text);
    REQUIRE(one.table);
    CHECK(one.table->rows.at(0).comment.size() > 500'000);
  }
}

TEST_CASE("Operands of a megabyte and of many parts are read in time") {
  const std::string long_operand = "Local:1:I" + repeated(".a", 500'000);
  read_soon(kCsvHeader + "ALIAS,,A,\"\",\"\",\"" + long_operand + "\",\"\"\nCOMMENT,,L,\"c\",\"\",\"" + long_operand +
            "\"\n");
  std::string list = kCsvHeader;
  for (int i = 0; i < kMany; ++i) {
    list += "COMMENT,,L,\"c\",\"\",\"L:1:I" + repeated(".a[1]", 10) + "." + std::to_string(i) + "\"\n";
  }
  const test::Reading reading = read_soon(list);
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == kMany);
}

TEST_CASE("A name of more than 65,536 bytes is one error") {
  const std::string name(70'000, 'n');
  for (const std::string& text : {kCsvHeader + "TAG,," + name + ",,BOOL\n", kProject + name + " : BOOL;\n",
                                  "HOST\tNAME\tDATATYPE\nH\t" + name + "\tBOOL\n"}) {
    const test::Reading reading = read_soon(text);
    CHECK_FALSE(reading.table);
    REQUIRE(reading.diagnostics.all().size() == 1);
    CHECK(reading.diagnostics.all()[0].rule->slug == "cell-too-long");
  }
}

TEST_CASE("A quote or a block that is not closed is one error") {
  for (const std::string& text :
       {kCsvHeader + "TAG,,A,\"text\n" + repeated("TAG,,B,x\n", kMany),
        "CXProgVer:=1;\nVariableList:=\nBEGIN_LIST_$#[5]\n" + repeated("A,1.0,BOOL,,,\n$?St$Bk?_#[6]\n", 1) +
            repeated("A,1.0,BOOL,,,;\n", kMany)}) {
    const test::Reading reading = read_soon(text);
    CHECK_FALSE(reading.table);
    REQUIRE(reading.diagnostics.all().size() == 1);
    CHECK(reading.diagnostics.all()[0].rule->slug == "unclosed-quote");
  }
}

TEST_CASE("A project with an unclosed string, bracket or comment loses only that declaration") {
  for (const std::string broken :
       {"A : BOOL (Description := \"open);", "A : BOOL (D := [1,(2);", "A : BOOL := [[;", "A BOOL;", "A", ": BOOL;",
        "A OF ;", "A : BOOL (", "$$$;", "A : B (K := \"x\" \"y);"}) {
    INFO(broken);
    const test::Reading reading = read_soon(kProject + "  " + broken + "\n  B : BOOL;\n C : BOOL := 1;\n END_TAG\n");
    REQUIRE(reading.table);
    CHECK(reading.table->rows.back().name == "C");
    CHECK(reading.diagnostics.count(diag::Severity::warning) == 1);
  }
  const test::Reading comment =
      read_soon(kProject + "A : BOOL;\n" + repeated("(* ", kMany) + "\nB : BOOL;\n END_TAG\n");
  REQUIRE(comment.table);
  CHECK(comment.table->rows.size() == 1);
}

TEST_CASE("Deep brackets and many broken declarations are read in time") {
  read_soon(kProject + "A : DINT := " + repeated("[(", 1 << 20) + ";\nB : BOOL;\n");
  read_soon(kProject + "A : DINT (K := " + repeated("(", 1 << 20) + repeated(")", 1 << 20) + ");\nB : BOOL;\n");
  read_soon(kProject + repeated("A : DINT := [\n", kMany));
  read_soon(kProject + repeated("A : DINT (K := \"\n", kMany));
  read_soon(kProject + repeated("A : DINT (K := '\n;", kMany));
  read_soon(kProject + repeated("(* *)", kMany));
  read_soon(kProject + repeated("A : T (", 1) + repeated("K := 1, ", kMany) + ");");
  read_soon(repeated("IE_VER\nCONTROLLER C\nTAG\nEND_TAG\n", kMany));
}

TEST_CASE("Exports with CR line ends only are read") {
  const std::vector<std::string> texts{
      "TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES\rTAG,,A,\"\",\"BOOL\",\"\",\"\"\rTAG,,B,\"\","
      "\"BOOL\"\r",
      "IE_VER := 2.21;\rCONTROLLER C (Major := 30)\r TAG\r  A : BOOL;\r  B : BOOL;\r END_TAG\r",
      "126,A                       I       0.0 BOOL\r126,B                       I       0.1 BOOL\r",
      "\"A                       \",\"I       0.0 \",\"BOOL      \",\"\"\r\"B\",\"I 0.1\",\"BOOL\",\"\"\r",
      "\"A\",\"%I0.0\",\"Bool\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\r"
      "\"B\",\"%I0.1\",\"Bool\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\r",
      "CXProgVer:=\"1.8\";\rVariableList:=\rBEGIN_LIST_$#[5]\rA,1.0,BOOL,,,\r$?St$Bk?_#[6]\rc\r$?St$Bk?_#[6];\r"
      "B,1.1,BOOL,,,;\rEND_LIST_$#[5];\r",
      "HOST\tNAME\tDATATYPE\tADDRESS\tCOMMENT\tTAGLINK\tRW\tPOU\rH\tA\tBOOL\rH\tB\tBOOL\r"};
  for (const std::string& text : texts) {
    INFO(text.substr(0, 40));
    const test::Reading reading = test::read_text(text);
    REQUIRE(reading.table);
    REQUIRE(reading.table->rows.size() == 2);
    CHECK(reading.table->rows[1].name == "B");
    CHECK(reading.table->source->position(reading.table->rows[1].whole.begin).line == reading.table->rows[1].line);
    CHECK(reading.diagnostics.all().empty());
  }
}

TEST_CASE("A requested format reads any text without fault") {
  for (const read::ReaderInfo* reader : read::readers()) {
    for (const char* const text :
         {"x\n", "\"\n", "TAG\n", "126,", "BEGIN_LIST_$#[", "VariableList:=", "TYPE,SCOPE,NAME,\nTAG"}) {
      INFO(reader->name << ": " << text);
      read::ReadOptions options;
      options.input_format = std::string(reader->name);
      const test::Reading reading = test::read_text(text, "list.csv", options);
      CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
    }
  }
}
