// Reads lists in every layout and compares them with goldens.
#include <filesystem>
#include <set>

#include "read_support.hpp"

using namespace symplant;
namespace fs = std::filesystem;
using test::kGoldens;

TEST_CASE("The paper's list gives the same table in every layout and encoding") {
  const std::string folder = kGoldens + "figure6/";
  std::size_t variants = 0;
  for (const std::string& file : test::lists_in(folder)) {
    INFO(file);
    const test::Reading reading = test::read_golden(folder + file);
    REQUIRE(reading.table);
    CHECK(reading.diagnostics.all().empty());
    test::check_golden(folder + "expected.txt", test::rows_as_text(*reading.table));
    ++variants;
  }
  CHECK(variants == 24);
}

TEST_CASE("The paper's list as an example is the first variant") {
  const std::string folder = kGoldens + "figure6/";
  CHECK(test::read_bytes(kGoldens + "../../../examples/excell/excell.csv") == test::read_bytes(folder + "comma.csv"));
}

TEST_CASE("Lists of other shapes are read as expected") {
  const std::string folder = kGoldens + "layouts/";
  for (const std::string& file : test::lists_in(folder)) {
    INFO(file);
    const test::Reading reading = test::read_golden(folder + file);
    REQUIRE(reading.table);
    std::string text = test::rows_as_text(*reading.table) + "\n";
    for (const std::string& decision : reading.table->decisions) text += decision + "\n";
    test::check_golden(folder + file + ".expected.txt", text);
  }
}

TEST_CASE("Each row knows its line, its bytes and the location of its cells") {
  const test::Reading reading = test::read_text("Class,Identifier,MIT-Addr.\r\n\r\nVAR_GLOBAL,A_B,X1\r\n");
  REQUIRE(reading.table);
  REQUIRE(reading.table->rows.size() == 1);
  const read::ListRow& row = reading.table->rows[0];
  const text::SourceFile& source = *reading.table->source;
  CHECK(row.line == 3);
  CHECK(source.text().substr(row.whole.begin, row.whole.end - row.whole.begin) == "VAR_GLOBAL,A_B,X1");
  CHECK(source.position(source.span_of(row.name).begin).column == 12);
  CHECK(row.type.empty());
}

TEST_CASE("A moved table keeps its copied cells") {
  test::Reading reading = test::read_text("Class,Identifier,Comment\nVAR_GLOBAL,A,\"a \"\"b\"\" c\"\n");
  REQUIRE(reading.table);
  const read::SymbolTable moved = std::move(*reading.table);
  CHECK(moved.rows[0].comment == "a \"b\" c");
}

TEST_CASE("A symbol with the name of a header column is a symbol") {
  const test::Reading reading = test::read_text("Name,MIT-Addr.,Type\nName,X1,BOOL\nB,X2,BOOL\n");
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 2);
}

TEST_CASE("A cell of more than 65,536 bytes is rejected with its location, a long comment is not") {
  const std::string header = "Class,Identifier,Type,Comment\n";
  const auto read = [&](std::size_t name, std::size_t comment) {
    return test::read_text(header + "VAR_GLOBAL,A,BOOL,x\nVAR_GLOBAL," + std::string(name, 'B') + ",BOOL," +
                           std::string(comment, 'c') + "\n");
  };
  CHECK(read(65'536, 1'000'000).table.has_value());
  const test::Reading refused = read(65'537, 0);
  CHECK_FALSE(refused.table.has_value());
  REQUIRE(refused.diagnostics.all().size() == 1);
  const diag::Diagnostic& finding = refused.diagnostics.all().front();
  CHECK(finding.rule->slug == "cell-too-long");
  CHECK(finding.location.span.begin == header.size() + std::string_view("VAR_GLOBAL,A,BOOL,x\nVAR_GLOBAL,").size());
}

TEST_CASE("Malformed lists of many megabytes are read in one pass") {
  const std::string header = "Class,Identifier,MIT-Addr.\n";
  const std::size_t size = 3000000;
  for (const std::string& text :
       {header + std::string(size, ','), header + "VAR_GLOBAL,A," + std::string(size, 'x'), std::string(size, ','),
        std::string(size, '"'), header + std::string(size, '\n'), std::string(size, 'x'),
        header + std::string(size, '\t'), header + "VAR_GLOBAL,A," + std::string(size, '"')}) {
    const test::Reading reading = test::read_text(text);
    CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
    CHECK(diag::render_text(reading.diagnostics.all()).size() < 10000);
  }
}
