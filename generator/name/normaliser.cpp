// Normalises texts; replacements by RE2.
#include "name/normaliser.hpp"

#include <re2/re2.h>

#include <algorithm>
#include <utility>

#include "text/ascii.hpp"
#include "text/folding.hpp"
#include "text/utf8.hpp"

namespace symplant::name {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// `$1` as RE2 writes it; a backslash is a character.
std::string rewrite_of(std::string_view replacement) {
  std::string rewrite;
  for (std::size_t i = 0; i < replacement.size(); ++i) {
    if (replacement[i] == '\\') {
      rewrite += "\\\\";
    } else if (replacement[i] == '$' && i + 1 < replacement.size() && text::is_digit(replacement[i + 1])) {
      rewrite += '\\';
    } else {
      rewrite += replacement[i];
    }
  }
  return rewrite;
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

/// A blank before each capital letter that begins a word.
std::string camel_case_parted(std::string_view text) {
  std::string parted;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i > 0 && is_upper(text[i]) &&
                        (is_lower(text[i - 1]) || text::is_digit(text[i - 1]) ||
                         (is_upper(text[i - 1]) && i + 1 < text.size() && is_lower(text[i + 1])));
    if (begins) parted += ' ';
    parted += text[i];
  }
  return parted;
}

/// A blank at each boundary of columns at which a word of the vocabulary begins.
std::string columns_parted(std::string_view text, std::uint32_t width, const Vocabulary& vocabulary,
                           const Separators& separators) {
  std::string parted;
  std::uint32_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint character = text::code_point_at(text, at);
    if (column != 0 && column % width == 0 && separators.length_at(text, at) == 0) {
      std::size_t end = at;
      while (end < text.size() && separators.length_at(text, end) == 0) {
        end += text::code_point_at(text, end).length;
      }
      if (vocabulary.knows(text::folded(text.substr(at, end - at)))) parted += ' ';
    }
    parted.append(text.substr(at, character.length));
    column += static_cast<std::uint32_t>(std::max(text::column_width(character.value), 0));
    at += character.length;
  }
  return parted;
}

void collapse_blanks(std::string& text) {
  std::size_t kept = 0;
  for (const char c : text) {
    const char wanted = is_blank(c) ? ' ' : c;
    if (wanted == ' ' && (kept == 0 || text[kept - 1] == ' ')) continue;
    text[kept++] = wanted;
  }
  text.resize(kept);
  if (!text.empty() && text.back() == ' ') text.pop_back();
}

}  // namespace

struct Replacements::Compiled {
  std::unique_ptr<re2::RE2> expression;
  std::string rewrite;
};

Replacements::Replacements(const std::vector<Replacement>& replacements,
                           std::vector<std::pair<std::size_t, std::string>>& faults) {
  for (std::size_t i = 0; i < replacements.size(); ++i) {
    auto expression = std::make_unique<re2::RE2>(replacements[i].expression, re2::RE2::Quiet);
    std::string rewrite = rewrite_of(replacements[i].replacement);
    std::string reason;
    if (!expression->ok()) {
      faults.emplace_back(i, expression->error());
    } else if (!expression->CheckRewriteString(rewrite, &reason)) {
      faults.emplace_back(i, "the replacement names a group that the expression lacks");
    } else {
      compiled_.push_back({std::move(expression), std::move(rewrite)});
    }
  }
}
Replacements::Replacements() = default;
Replacements::~Replacements() = default;
Replacements::Replacements(Replacements&&) noexcept = default;
Replacements& Replacements::operator=(Replacements&&) noexcept = default;

bool Replacements::empty() const { return compiled_.empty(); }

void Replacements::apply(std::string& text) const {
  for (const Compiled& one : compiled_) re2::RE2::GlobalReplace(&text, *one.expression, one.rewrite);
}

std::string normalised(std::string_view text, const Normalise& rules, const Vocabulary& vocabulary,
                       const Separators& separators) {
  std::string result = text::normal_form(text);
  if (!rules.line_break.empty()) replace_all(result, rules.line_break, " ");
  if (rules.columns != 0) result = columns_parted(result, rules.columns, vocabulary, separators);
  if (rules.camel_case) result = camel_case_parted(result);
  if (rules.collapse) collapse_blanks(result);
  return result;
}

}  // namespace symplant::name
