// Reads the tags of Logix Designer projects in text form (.L5K).
#include <optional>
#include <string>
#include <vector>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rockwell/l5k_declaration.hpp"
#include "read/rockwell/tags.hpp"
#include "read/rules/row_not_understood.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kL5kHeaderBytes = 64 * 1024;

bool is_l5k_word(char c) { return text::is_digit(c) || c == '_' || (text::upper(c) >= 'A' && text::upper(c) <= 'Z'); }

/// The word at the begin of `text`.
std::string_view first_l5k_word(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_l5k_word(text[end])) ++end;
  return text.substr(0, end);
}

class L5kReading {
 public:
  explicit L5kReading(const Reading& reading)
      : builder_(reading, address::Notation::rockwell), tags_(builder_, RockwellTags::Texts::escaped) {}

  std::optional<SymbolTable> read() {
    LineReader lines(builder_.text());
    Line line;
    while (lines.next(line)) {
      const std::string_view text = without_blanks(line.text);
      if (text.starts_with("(*")) {
        lines = behind_comment(line);
        continue;
      }
      const std::string_view word = first_l5k_word(text);
      if (word == "PROGRAM") scope_ = first_l5k_word(without_blanks(text.substr(word.size())));
      if (word == "END_PROGRAM") scope_ = {};
      if (word == "MODULE" || word == "END_MODULE") in_module_ = word == "MODULE";
      if (in_module_ && text.find("COMMENT") != std::string_view::npos && text.find(":=") != std::string_view::npos) {
        ++comments_of_modules_;
      }
      if (word == "TAG" && word.size() == text.size()) lines = read_tags(lines);
    }
    if (comments_of_modules_ != 0) {
      builder_.decide("comments in sections of modules: " + std::to_string(comments_of_modules_) + ", not read");
    }
    tags_.make_rows();
    return builder_.finish();
  }

 private:
  /// Where the lines go on behind the comment with which a line begins.
  LineReader behind_comment(const Line& line) const {
    const std::string_view text = builder_.text();
    const std::size_t end = skip_l5k_blanks(text, line.begin);
    return LineReader(text, end, line.number + count_lines(text.substr(line.begin, end - line.begin)));
  }

  /// Reads the declarations from there to END_TAG; returns where the lines go on.
  LineReader read_tags(const LineReader& begin) {
    const std::string_view text = builder_.text();
    std::size_t at = begin.offset();
    std::uint32_t number = begin.number();
    L5kDeclaration declaration;
    for (;;) {
      const std::size_t from = skip_l5k_blanks(text, at);
      number += count_lines(text.substr(at, from - at));
      at = from;
      if (at >= text.size() || first_l5k_word(text.substr(at)) == "END_TAG") break;
      const std::size_t end = parse_l5k_declaration(text, at, declaration);
      if (declaration.valid) {
        add(declaration, {at, end}, number);
      } else {
        builder_.report(kRowNotUnderstood,
                        "this declaration does not have the form `NAME : TYPE (...) := ...;` or `NAME OF TARGET "
                        "(...);` and is left out; export the project again",
                        {at, end});
      }
      number += count_lines(text.substr(at, end - at));
      at = end;
    }
    return LineReader(text, at, number);
  }

  static std::uint32_t count_lines(std::string_view text) {
    LineReader lines(text);
    Line line;
    while (lines.next(line)) {
    }
    const bool ended = !text.empty() && (text.back() == '\n' || text.back() == '\r');
    return text.empty() ? 0 : lines.number() - (ended ? 1 : 2);
  }

  void add(const L5kDeclaration& declaration, text::Span whole, std::uint32_t number) {
    RockwellTag tag{scope_, declaration.name, declaration.type, declaration.target, {}, number, whole};
    std::size_t at = whole.begin;
    for (const L5kAttribute& attribute : declaration.attributes) {
      const std::string_view key = attribute.key;
      if (text::equal_ignoring_case(key, "Description")) tag.comment = joined(attribute);
      if (!text::equal_ignoring_case(key.substr(0, kComment.size()), kComment)) continue;
      const std::string_view operand = builder_.keep(std::string(declaration.name).append(key.substr(kComment.size())));
      const std::size_t begin = builder_.source().span_of(key, whole).begin;
      number += count_lines(builder_.text().substr(at, begin - at));
      at = begin;
      tags_.add(RockwellComment{scope_, operand, joined(attribute), number, {begin, attribute.end}});
    }
    tags_.add(tag);
  }

  /// The text of an attribute, which may be in several strings.
  std::string_view joined(const L5kAttribute& attribute) {
    if (attribute.strings.empty()) return {};
    if (attribute.strings.size() == 1) return attribute.strings.front();
    std::string text;
    for (const std::string_view part : attribute.strings) text += part;
    return builder_.keep(std::move(text));
  }

  static constexpr std::string_view kComment = "COMMENT";

  TableBuilder builder_;
  RockwellTags tags_;
  std::string_view scope_;
  bool in_module_ = false;
  std::size_t comments_of_modules_ = 0;
};

int rockwell_l5k_likelihood(std::string_view text) {
  LineReader lines(text.substr(0, kL5kHeaderBytes));
  Line line;
  bool has_version = false;
  while (lines.next(line)) {
    const std::string_view word = first_l5k_word(without_blanks(line.text));
    if (word == "IE_VER") has_version = true;
    if (word == "CONTROLLER" && has_version) return 95;
  }
  return has_version ? 60 : 0;
}

std::optional<SymbolTable> read_rockwell_l5k(const Reading& reading) { return L5kReading(reading).read(); }

}  // namespace

const ReaderInfo kRockwellL5k{"rockwell-l5k", "Logix Designer project as text (.L5K)", rockwell_l5k_likelihood,
                              read_rockwell_l5k};

}  // namespace symplant::read
