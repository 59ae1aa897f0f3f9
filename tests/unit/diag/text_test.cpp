// Findings as text.
#include "diag/text.hpp"

#include "support/catch.hpp"
#include "support/strings.hpp"

using namespace symplant;
using diag::Diagnostics;
using diag::render_text;

namespace {

constexpr diag::RuleInfo kRule{"SP201", "wrong-number-of-levels", diag::Severity::warning, "", ""};
constexpr diag::RuleInfo kError{"SP101", "cannot-read-file", diag::Severity::error, "", ""};

std::shared_ptr<const text::SourceFile> source_of(std::string text) {
  return std::make_shared<text::SourceFile>("list.csv", std::move(text));
}

std::string rendered(const std::string& text, text::Span span) {
  Diagnostics found;
  found.add(kRule, "odd", {source_of(text), span});
  return render_text(found.all());
}

/// The last line: the underline.
std::string underline(const std::string& text, text::Span span) {
  std::string all = rendered(text, span);
  all.pop_back();
  return all.substr(all.rfind('\n') + 1);
}

}  // namespace

TEST_CASE("A finding shows its row and underlines its location") {
  CHECK(rendered("first\nVAR_GLOBAL,A_B,X1\n", {17, 20}) ==
        "list.csv:2:12: warning: odd [SP201 wrong-number-of-levels]\n"
        "    2 | VAR_GLOBAL,A_B,X1\n"
        "      |            ^~~\n");
}

TEST_CASE("Related locations follow as notes") {
  const auto source = source_of("A,X1\nA,X2\n");
  Diagnostics found;
  std::vector<diag::Related> related(1);
  related[0].location = {source, {0, 1}};
  related[0].message = "first declared here";
  found.add(kRule, "`A` again", {source, {5, 6}}, related);
  CHECK(render_text(found.all(), {.all = true}) ==
        "list.csv:2:1: warning: `A` again [SP201 wrong-number-of-levels]\n"
        "    2 | A,X2\n"
        "      | ^\n"
        "list.csv:1:1: note: first declared here\n"
        "    1 | A,X1\n"
        "      | ^\n");
}

TEST_CASE("A row is shown once for successive findings at one location") {
  const auto source = source_of("A,X1\nA,X2\n");
  Diagnostics found;
  std::vector<diag::Related> related{
      {{source, {0, 1}}, "follows"}, {{source, {5, 6}}, "there"}, {{source, {0, 1}}, "as before"}};
  found.add(kRule, "odd", {source, {0, 1}}, related);
  CHECK(render_text(found.all(), {.all = true}) ==
        "list.csv:1:1: warning: odd [SP201 wrong-number-of-levels]\n"
        "    1 | A,X1\n"
        "      | ^\n"
        "list.csv:1:1: note: follows\n"
        "list.csv:2:1: note: there\n"
        "    2 | A,X2\n"
        "      | ^\n"
        "list.csv:1:1: note: as before\n"
        "    1 | A,X1\n"
        "      | ^\n");
}

TEST_CASE("The underline matches tabs, wide, combining and escaped characters") {
  CHECK(underline("a\tb", {2, 3}) == "      |     ^");
  CHECK(underline("\xEC\x9A\xB4\xEC\xA0\x84,b", {7, 8}) == "      |      ^");
  CHECK(underline("\xEC\x9A\xB4\xEC\xA0\x84", {3, 6}) == "      |   ^~");
  CHECK(underline("e\xCC\x81,b", {4, 5}) == "      |   ^");
  CHECK(underline("\x01,b", {2, 3}) == "      |          ^");
}

TEST_CASE("An empty location and one at the end of the row get one mark") {
  CHECK(underline("abc", {1, 1}) == "      |  ^");
  CHECK(underline("abc\n", {3, 3}) == "      |    ^");
}

TEST_CASE("A location over several rows is underlined to the end of its first row") {
  CHECK(underline("ab\ncd", {1, 5}) == "      |  ^");
  CHECK(underline("abcd\nef", {1, 7}) == "      |  ^~~");
}

TEST_CASE("A long row is cut to a window around the location") {
  const std::string text = std::string(500, 'x') + "HERE" + std::string(500, 'y');
  const std::string all = rendered(text, {500, 504});
  CHECK(all.substr(all.find('\n') + 1) == "    1 | \xE2\x80\xA6" + std::string(40, 'x') + "HERE" +
                                              std::string(75, 'y') + "\xE2\x80\xA6\n      | " + std::string(41, ' ') +
                                              "^~~~\n");
}

TEST_CASE("A long row is shown from its beginning if the location is near it") {
  const std::string all = rendered("HERE" + std::string(1000, 'y'), {0, 4});
  CHECK(all.substr(all.find('\n') + 1) == "    1 | HERE" + std::string(116, 'y') + "\xE2\x80\xA6\n      | ^~~~\n");
}

TEST_CASE("A location longer than the window is underlined to the end of the window") {
  const std::string line = underline(std::string(100000, 'x'), {0, 100000});
  CHECK(line == "      | ^" + std::string(119, '~'));
}

TEST_CASE("A finding in an empty text shows no line, one without a source no file") {
  Diagnostics found;
  found.add(kError, "empty", {source_of(""), {}});
  found.add(kError, "cannot", {});
  CHECK(render_text(found.all()) ==
        "list.csv: error: empty [SP101 cannot-read-file]\n"
        "error: cannot [SP101 cannot-read-file]\n");
}

TEST_CASE("User text in messages and paths cannot control the terminal") {
  Diagnostics found;
  found.add(kError, "name `\x1b[2J`", {std::make_shared<text::SourceFile>("a\nb.csv", ""), {}});
  CHECK(render_text(found.all()) == "a<U+000A>b.csv: error: name `<U+001B>[2J` [SP101 cannot-read-file]\n");
}

TEST_CASE("Color is used only if requested") {
  Diagnostics found;
  found.add(kRule, "odd", {source_of("abc"), {0, 1}});
  CHECK(render_text(found.all()).find('\x1b') == std::string::npos);
  const std::string coloured = render_text(found.all(), {.colour = true});
  CHECK(coloured ==
        "\x1b[1mlist.csv:1:1: \x1b[0m\x1b[1;35mwarning:\x1b[0m odd [SP201 wrong-number-of-levels]\n"
        "    1 | abc\n      | \x1b[1;32m^\x1b[0m\n");
}

/// How often a text has a word.
std::size_t count_of(const std::string& text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST_CASE("Three warnings of a rule are shown, every error, and the rest are counted") {
  const auto source = source_of("abc");
  Diagnostics found;
  for (int i = 0; i < 5; ++i) found.add(kRule, "odd", {source, {0, 1}});
  for (int i = 0; i < 4; ++i) found.add(kError, "bad", {source, {0, 1}});
  const std::string text = render_text(found.all());
  CHECK_THAT(text, Catch::Matchers::StartsWith("list.csv:1:1: error: bad"));
  CHECK_THAT(text, Catch::Matchers::EndsWith("... and more warnings: 2 wrong-number-of-levels; --verbose shows all\n"));
  CHECK(count_of(text, "odd") == 3);
  CHECK(count_of(text, "bad") == 4);
  const std::string all = render_text(found.all(), {.all = true});
  CHECK_THAT(all, Catch::Matchers::StartsWith("list.csv:1:1: warning: odd"));
  CHECK(count_of(all, "odd") == 5);
  CHECK(all.find("... and") == std::string::npos);
}

TEST_CASE("No more findings than asked are shown, errors excepted") {
  const auto source = source_of("abc");
  Diagnostics found;
  for (int i = 0; i < 2; ++i) found.add(kRule, "odd", {source, {0, 1}});
  for (int i = 0; i < 3; ++i) found.add(kError, "bad", {source, {0, 1}});
  const std::string text = render_text(found.all(), {.most = 1, .most_errors = 2});
  CHECK(count_of(text, "odd") == 0);
  CHECK(count_of(text, "bad") == 2);
  CHECK_THAT(text, Catch::Matchers::EndsWith("... and more errors: 1 cannot-read-file; --verbose shows all\n"
                                             "... and more warnings: 2 wrong-number-of-levels; --verbose shows all\n"));
}

TEST_CASE("Five errors of a rule are shown, and no more lines than asked after the first finding") {
  const auto source = source_of("abc");
  Diagnostics found;
  for (int i = 0; i < 20; ++i) found.add(kError, "bad", {source, {0, 1}}, {{{source, {1, 2}}, "also"}});
  const std::string text = render_text(found.all());
  CHECK(count_of(text, "bad") == 5);
  CHECK(count_of(text, "\n") <= 40);
  CHECK_THAT(text, Catch::Matchers::EndsWith("... and more errors: 15 cannot-read-file; --verbose shows all\n"));
  Diagnostics alone;  // without notes there is room for more than five
  for (int i = 0; i < 20; ++i) alone.add(kError, "bad", {source, {0, 1}});
  CHECK(count_of(render_text(alone.all()), "bad") == 5);
  CHECK(count_of(render_text(found.all(), {.most_lines = 13}), "bad") == 2);
  CHECK(count_of(render_text(found.all(), {.most_lines = 1}), "bad") == 1);
}

TEST_CASE("Notes are counted by rule, unless they are asked for") {
  constexpr diag::RuleInfo kNote{"SP404", "event-not-driven", diag::Severity::note, "", ""};
  const auto source = source_of("abc");
  Diagnostics found;
  for (int i = 0; i < 5; ++i) found.add(kNote, "still", {source, {0, 1}});
  CHECK(render_text(found.all()) == "... and notes: 5 event-not-driven; --verbose shows all\n");
  const std::string text = render_text(found.all(), {.least = diag::Severity::note});
  CHECK(count_of(text, "still") == 3);
  CHECK_THAT(text, Catch::Matchers::EndsWith("... and more notes: 2 event-not-driven; --verbose shows all\n"));
}

TEST_CASE("Of findings of one severity, those on rows and addresses come first, then what concerns most symbols") {
  constexpr diag::RuleInfo kAddress{"SP303", "address-used-twice", diag::Severity::warning, "", ""};
  const auto source = source_of("abc");
  Diagnostics found;
  found.add(kRule, "one", {source, {0, 1}});
  diag::Diagnostic many{&kRule, diag::Severity::warning, "nine", {source, {0, 1}}, {}, {}};
  many.count = 9;
  found.add(many);
  found.add(kAddress, "first", {source, {0, 1}});
  const std::string text = render_text(found.all());
  CHECK(text.find("first") < text.find("nine"));
  CHECK(text.find("nine") < text.find("one"));
}

TEST_CASE("Of many related rows the first are shown and the rest counted, of a finding of many none") {
  const auto source = source_of("abc");
  Diagnostics found;
  std::vector<diag::Related> related(12, {{source, {0, 1}}, "the same"});
  found.add(kRule, "odd", {source, {0, 1}}, related);
  const std::string text = render_text(found.all());
  CHECK(count_of(text, "the same") == 3);
  CHECK_THAT(text, Catch::Matchers::EndsWith("... and 9 more related rows; --verbose shows all\n"));
  CHECK(count_of(render_text(found.all(), {.all = true}), "the same") == 12);
  diag::Diagnostic joined = found.all().front();
  joined.count = 2;
  CHECK(count_of(render_text(std::span(&joined, 1)), "the same") == 0);
}

TEST_CASE("Findings are counted by severity") {
  Diagnostics found;
  CHECK_FALSE(found.has_errors());
  found.add(kRule, "odd", {});
  CHECK_FALSE(found.has_errors());
  found.add(kError, "bad", {});
  CHECK(found.has_errors());
  CHECK(found.count(diag::Severity::warning) == 1);
  CHECK(found.count(diag::Severity::note) == 0);
}
