// Exports of several tools are read as expected, and each is recognized by its content alone.
#include "read_support.hpp"

using namespace symplant;
using test::kGoldens;

TEST_CASE("Exports of the formats are read as expected") {
  const std::string folder = kGoldens + "formats/";
  for (const std::string& file : test::lists_in(folder)) {
    INFO(file);
    read::ReadOptions options;
    if (file == "symbols.asc") options.encoding = text::Encoding::cp1252;
    const test::Reading reading = test::read_text(test::read_bytes(folder + file), file, options);
    REQUIRE(reading.table);
    std::string text = test::rows_with_extras(*reading.table) + "\n";
    for (const std::string& decision : reading.table->decisions) text += decision + "\n";
    text += "\n" + diag::render_text(reading.diagnostics.all(), {.all = true});
    test::check_golden(folder + file + ".expected.txt", text);
  }
}

TEST_CASE("An export of one format is not one of another") {
  for (const std::string folder : {"formats/", "layouts/", "figure6/"}) {
    for (const std::string& file : test::lists_in(kGoldens + folder)) {
      INFO(folder << file);
      auto decoded = text::decode(test::read_bytes(kGoldens + folder + file));
      if (!decoded) continue;
      std::vector<int> likelihoods;
      for (const read::ReaderInfo* reader : read::readers()) {
        likelihoods.push_back(reader->likelihood(decoded->text));
      }
      std::sort(likelihoods.rbegin(), likelihoods.rend());
      CHECK(likelihoods[0] >= 20);
      CHECK(likelihoods[0] > likelihoods[1]);
    }
  }
}

TEST_CASE("Exports of the same tools in other formats are not taken for these") {
  for (const char* const text :
       {"\tI 0.0\tGate\tcomment\r\n", "TABLE\r\n0,1\r\n\"EXCEL\"\r\nVECTORS\r\n0,4\r\n",
        "-F00000000;iGate;I 0.0;comment\r\n", "<?xml version=\"1.0\"?>\n<RSLogix5000Content/>\n",
        "\"a\",\"b\",\"c\",\"d\"\n", "Type,Scope,Variable,Address,DataType,Property,Comment\n"}) {
    INFO(text);
    for (const read::ReaderInfo* reader : read::readers()) {
      const std::string_view name = reader->name;
      if (name == "omron-cxt" || name == "sysmac" || name == "tia-sdf" || name.starts_with("step7") ||
          name == "rockwell-csv" || name == "rockwell-l5k") {
        CHECK(reader->likelihood(text) == 0);
      }
    }
  }
}

TEST_CASE("Cells that are in the file as such are views into it, so that findings point to them") {
  for (const std::string file : {"logix_tags.csv", "project.L5K", "project.cxt", "PLCTags.sdf", "symbols.sdf"}) {
    INFO(file);
    const test::Reading reading = test::read_golden(kGoldens + "formats/" + file);
    REQUIRE(reading.table);
    const text::SourceFile& source = *reading.table->source;
    for (const read::ListRow& row : reading.table->rows) {
      INFO(row.name);
      const text::Span name = source.span_of(row.name);
      const std::string_view scope = reading.table->extra_of(row).scope;
      const bool scoped = !scope.empty() && row.name.starts_with(scope);
      const bool of_comment = row.name == "Word.7" || row.name == "Local:2:I.Data.3";
      CHECK((scoped || of_comment || (name.begin >= row.whole.begin && name.end <= row.whole.end)));
      CHECK(source.position(row.whole.begin).line == row.line);
    }
  }
}
