// The declarations of variables in Structured Text.
#include "read/st/declarations.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "read/st/declaration_grammar.hpp"
#include "read/st/surroundings.hpp"
#include "read/st/tokens.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

using st::Kind;
using st::Token;
using st::Tokens;

constexpr std::array<std::string_view, 12> kBlocks{"VAR",          "VAR_INPUT",  "VAR_OUTPUT", "VAR_IN_OUT",
                                                   "VAR_TEMP",     "VAR_STAT",   "VAR_INST",   "VAR_GLOBAL",
                                                   "VAR_EXTERNAL", "VAR_CONFIG", "VAR_ACCESS", "VAR_GENERIC"};
constexpr std::array<std::string_view, 8> kQualifiers{"CONSTANT", "RETAIN",  "NON_RETAIN", "PERSISTENT",
                                                      "PUBLIC",   "PRIVATE", "PROTECTED",  "INTERNAL"};
constexpr std::array<std::string_view, 7> kHeads{"PROGRAM",  "FUNCTION_BLOCK",     "FUNCTION",  "CONFIGURATION",
                                                 "RESOURCE", "ORGANIZATION_BLOCK", "DATA_BLOCK"};
constexpr std::array<std::string_view, 5> kModifiers{"PUBLIC", "PRIVATE", "INTERNAL", "ABSTRACT", "FINAL"};
constexpr std::array<std::string_view, 6> kEnds{"END_PROGRAM",       "END_FUNCTION_BLOCK", "END_FUNCTION",
                                                "END_CONFIGURATION", "END_RESOURCE",       "END_ORGANIZATION_BLOCK"};

constexpr std::string_view kBlockEnd = "END_VAR";

template <class Words>
bool is_one_of(const Words& words, std::string_view word) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view other) { return text::equal_ignoring_case(other, word); });
}

class DeclarationReading {
 public:
  DeclarationReading(std::string_view text, text::Span range, DeclarationVisitor& visitor)
      : tokens_(text, range), visitor_(visitor), around_(text) {}

  void read() {
    for (Token token = tokens_.next(); token.kind != Kind::end; token = tokens_.next()) {
      if (token.kind != Kind::word) continue;
      const std::string_view word = tokens_.text_of(token);
      if (!may_be_keyword(word)) continue;
      if (is_one_of(kBlocks, word)) {
        read_block(token);
      } else if (is_one_of(kHeads, word)) {
        scope_ = name_after_head();
      } else if (is_one_of(kEnds, word)) {
        scope_ = {};
      }
    }
    if (const auto begin = tokens_.unclosed_comment()) visitor_.unclosed_comment({*begin, *begin + 2});
  }

 private:
  static bool may_be_keyword(std::string_view word) {
    return word.size() >= 3 && std::string_view("VPFCROED").find(text::upper(word.front())) != std::string_view::npos;
  }

  std::string_view name_after_head() {
    for (;;) {
      const Token token = tokens_.next_of_code();
      const std::string_view word = tokens_.text_of(token);
      if (token.kind == Kind::quoted && word.size() > 2) return word.substr(1, word.size() - 2);
      if (token.kind == Kind::word && !is_one_of(kModifiers, word)) return word;
      if (token.kind != Kind::word) {
        tokens_.go_to(token.begin);
        return {};
      }
    }
  }

  /// The head of a block after its first word. A variable may have the name of a qualifier.
  void read_head(std::string_view word) {
    block_.klass = text::to_upper(word);
    block_.scope = scope_;
    block_.kind = block_.klass == "VAR_GLOBAL"   ? VariableBlock::Kind::global
                  : block_.klass == "VAR_CONFIG" ? VariableBlock::Kind::config
                                                 : VariableBlock::Kind::local;
    for (;;) {
      const std::size_t end = tokens_.offset();
      const Token token = tokens_.next_of_code();
      const std::string_view qualifier = tokens_.text_of(token);
      const Token after = tokens_.next_of_code();
      tokens_.go_to(end);
      const bool is_name = tokens_.is_mark(after, ':') || tokens_.is_mark(after, ',') || tokens_.is_word(after, "AT");
      if (token.kind != Kind::word || is_name || !is_one_of(kQualifiers, qualifier)) return;
      block_.klass.append("_").append(text::to_upper(qualifier));
      tokens_.go_to(token.end);
    }
  }

  void read_block(const Token& head) {
    read_head(tokens_.text_of(head));
    const bool declares = block_.klass != "VAR_EXTERNAL" && block_.klass != "VAR_ACCESS";
    around_.begin(tokens_.offset());
    has_pending_ = false;
    for (;;) {
      const Token token = tokens_.next();
      if (token.kind == Kind::comment || token.kind == Kind::pragma) {
        take_around(token);
        continue;
      }
      around_.pass(token);
      if (ends_block(token)) {
        flush();
        if (tokens_.is_word(token, kBlockEnd)) return;
        tokens_.go_to(token.begin);
        visitor_.faulty({head.begin, head.end}, "this block of variables has no `END_VAR`; add it after its variables");
        return;
      }
      if (!tokens_.is_mark(token, ';')) {
        read_declaration(token, declares);
        around_.begin(tokens_.offset());
      }
    }
  }

  bool ends_block(const Token& token) const {
    if (token.kind == Kind::end) return true;
    if (token.kind != Kind::word) return false;
    const std::string_view word = tokens_.text_of(token);
    return may_be_keyword(word) &&
           (text::equal_ignoring_case(word, kBlockEnd) || is_one_of(kBlocks, word) || is_one_of(kEnds, word));
  }

  void take_around(const Token& token) {
    const bool same_line = around_.pass(token);
    if (token.kind == Kind::pragma) return around_.take_link(tokens_.text_of(token));
    const std::string_view comment = st::comment_text(tokens_.text_of(token));
    if (!same_line) return around_.take_above(comment);
    if (!has_pending_ || comment_after_) return;
    comment_after_ = true;
    if (!comment.empty()) pending_.comment = comment;
  }

  /// Reads up to the `;`. What the block has after it may be its comment, so it is kept until then.
  void read_declaration(const Token& first, bool declares) {
    flush();
    std::string_view inside;
    Token token = first;
    for (; !tokens_.is_mark(token, ';') && !ends_block(token); token = tokens_.next()) {
      if (token.kind == Kind::comment && inside.empty()) inside = st::comment_text(tokens_.text_of(token));
      if (token.kind == Kind::pragma) around_.take_link(tokens_.text_of(token));
      if (token.kind == Kind::unclosed) return report_unclosed(token, declares);
    }
    if (!tokens_.is_mark(token, ';')) {
      tokens_.go_to(token.begin);
      if (declares) visitor_.faulty({first.begin, first.end}, "this declaration has no `;` at its end; add it");
      return;
    }
    if (!declares) return;
    const std::size_t end = tokens_.offset();
    const bool parses = st::parse_declaration(tokens_, {first.begin, token.begin}, parsed_);
    tokens_.go_to(end);
    if (!parses) {
      visitor_.faulty({first.begin, token.end},
                      "this is not a declaration of variables and is left out; write it as `NAME AT %IX0.0 : TYPE;`");
      return;
    }
    pending_ = {std::move(parsed_.names),
                parsed_.address,
                parsed_.type,
                parsed_.initial,
                inside.empty() ? around_.above() : inside,
                around_.link(),
                {first.begin, token.end}};
    has_pending_ = true;
    comment_after_ = false;
  }

  /// The line's end is taken to be the end of the declaration.
  void report_unclosed(const Token& text, bool declares) {
    if (declares)
      visitor_.faulty({text.begin, text.end}, "this text has no closing quote, so its declaration is left out; add it");
  }

  void flush() {
    if (!has_pending_) return;
    has_pending_ = false;
    visitor_.declared(block_, pending_);
    parsed_.names.swap(pending_.names);  // keeps its memory
  }

  Tokens tokens_;
  DeclarationVisitor& visitor_;
  st::Surroundings around_;
  VariableBlock block_;
  std::string_view scope_;
  st::ParsedDeclaration parsed_;
  Declaration pending_;
  bool has_pending_ = false;    // the last declaration still waits for the comment after it
  bool comment_after_ = false;  // it has one
};

/// Counts declarations, for the likelihood.
class DeclarationCount : public DeclarationVisitor {
 public:
  void declared(const VariableBlock& /*block*/, const Declaration& /*declaration*/) override { ++count; }
  void faulty(text::Span /*where*/, std::string /*fault*/) override {}
  void unclosed_comment(text::Span /*where*/) override {}

  std::size_t count = 0;
};

}  // namespace

void read_declarations(std::string_view text, text::Span range, DeclarationVisitor& visitor) {
  DeclarationReading(text, range, visitor).read();
}

int declarations_likelihood(std::string_view text) {
  constexpr std::size_t kBegin = 64 * 1024;
  text = text.substr(0, kBegin);
  Tokens tokens(text, {0, text.size()});
  const Token first = tokens.next_of_code();
  if (first.kind != Kind::word) return 0;
  const std::string_view word = tokens.text_of(first);
  const bool begins_with_block = is_one_of(kBlocks, word);
  if (!begins_with_block && !is_one_of(kHeads, word) && !tokens.is_word(first, "TYPE")) return 0;
  const Token second = tokens.next_of_code();
  if (second.kind != Kind::word && second.kind != Kind::quoted) return 0;
  DeclarationCount variables;
  read_declarations(text, {0, text.size()}, variables);
  if (variables.count != 0) return 95;
  const bool has_end = std::search(text.begin(), text.end(), kBlockEnd.begin(), kBlockEnd.end(),
                                   [](char a, char b) { return text::upper(a) == b; }) != text.end();
  return has_end ? 60 : 0;
}

}  // namespace symplant::read
