// User text reaches generated code only through an encoder.
#include <algorithm>

#include "emit/encode.hpp"
#include "emit_support.hpp"

namespace symplant::test {
namespace {

std::string hostile() { return read_bytes(kSource + "/tests/unit/emit/hostile.csv"); }

TEST_CASE("Generated files are printable ASCII for any list") {
  for (const Emitted::File& file : emit_list(hostile(), "h\xC3\xA4\"*/\\\xE2\x80\xAE{{plant}}.csv").files) {
    INFO(file.name);
    const bool printable = std::all_of(file.content.begin(), file.content.end(),
                                       [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; });
    CHECK(printable);
  }
}

TEST_CASE("No line ends in a backslash or a trigraph of one") {
  for (const Emitted::File& file : emit_list(hostile(), "hostile\\.csv").files) {
    INFO(file.name);
    for (std::size_t end = file.content.find('\n'); end != std::string::npos; end = file.content.find('\n', end + 1)) {
      std::size_t last = end;
      while (last > 0 && file.content[last - 1] == ' ') --last;
      const std::string_view line = std::string_view(file.content).substr(0, last);
      CHECK_FALSE(line.ends_with('\\'));
      CHECK_FALSE(line.ends_with("?\?/"));
    }
  }
}

TEST_CASE("Every symbol has a row: no comment swallows one") {
  const CompiledText text = compile_text(hostile(), "hostile.csv");
  REQUIRE(text.compiled);
  const std::string tables = file_of(emit_list(hostile(), "hostile.csv"), "tables_gen.cpp");
  const std::size_t begin = tables.find("kSymbols[] = {");
  REQUIRE(begin != std::string::npos);
  const std::string_view rows = std::string_view(tables).substr(begin, tables.find("\n};", begin) - begin);
  CHECK(static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n')) == text.plant().symbols.size());
}

TEST_CASE("Comments contain only printable ASCII without a backslash") {
  CHECK(emit::comment_text("a\\b") == "a<U+005C>b");
  CHECK(emit::comment_text("\r\n\t") == "<U+000D><U+000A><U+0009>");
  CHECK(emit::comment_text("\xE2\x80\xAE") == "<U+202E>");
  CHECK(emit::comment_text("\xF0\x9F\xA4\x96") == "<U+1F916>");
  CHECK(emit::comment_text("plain */ text") == "plain */ text");
  CHECK(emit::comment_text("what?/ what?\?/") == "what?/ what?<U+003F>/");
}

TEST_CASE("String literals escape what would end or change them") {
  CHECK(emit::string_literal("a\"b\\c") == "\"a\\042b\\134c\"");
  CHECK(emit::string_literal("?\?/") == "\"\\077\\077/\"");
  CHECK(emit::string_literal("\xC3\xA4"
                             "1") == "\"\\303\\2441\"");
  CHECK(emit::string_literal(std::string_view("\0001", 2)) == "\"\\0001\"");
}

TEST_CASE("A plant's name becomes a unique namespace") {
  CHECK(emit::namespace_of("excell") == "excell");
  CHECK(emit::namespace_of("press line-2.v1") == "press_line_2_v1");
  CHECK(emit::namespace_of("EBUSY") == "EBUSY_");
  for (const char* name : {"std", "symplant", "class", "NULL", "1st", "two words", "공정", "", "core", "errno"}) {
    const std::string made = emit::namespace_of(name);
    INFO(name);
    CHECK(made != name);
    CHECK_FALSE(made.empty());
    CHECK_FALSE((made.front() >= '0' && made.front() <= '9'));
  }
}

}  // namespace
}  // namespace symplant::test
