// The grammar of one declaration in Boost.Spirit X3.
#include "read/st/declaration_grammar.hpp"

#include <algorithm>
#include <boost/spirit/home/x3.hpp>

#include "text/ascii.hpp"

namespace symplant::read::st {
namespace {

namespace x3 = boost::spirit::x3;

/// Tags of the context: the tokens of the text, and what was parsed.
struct Scanner {};
struct Result {};

/// A part of the text that is parsed, and the tokens that begin with it.
struct Input {
  Tokens& tokens;
  std::size_t begin;
  std::size_t end;

  Token first_token() const {
    tokens.go_to(begin);
    return tokens.next();
  }
  char front() const { return begin < end ? tokens.text()[begin] : '\0'; }
};

Input input_of(Tokens& tokens, const char* first, const char* last) {
  const char* const text = tokens.text().data();
  return {tokens, static_cast<std::size_t>(first - text), static_cast<std::size_t>(last - text)};
}

/// Comments, pragmas and blanks: what is skipped between the parts of a declaration.
struct Skipped : x3::parser<Skipped> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  explicit Skipped(Tokens& of) : tokens(&of) {}
  template <class Context, class RuleContext, class Attribute>
  bool parse(const char*& first, const char* const& last, const Context&, RuleContext&, Attribute&) const {
    const Input input = input_of(*tokens, first, last);
    if (input.begin == input.end) return false;
    const Token token = input.first_token();
    const bool skips = token.kind == Kind::comment || token.kind == Kind::pragma;
    const std::size_t end = std::min(skips ? token.end : token.begin, input.end);
    first += end - input.begin;
    return end != input.begin;
  }

  Tokens* tokens;
};

/// A parser of what `Derived::end_in(input)` finds, which is the input's begin if it does not match.
template <class Derived>
struct TokenParser : x3::parser<Derived> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class Context, class RuleContext, class Attribute>
  bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&, Attribute&) const {
    x3::skip_over(first, last, context);
    const Input input = input_of(x3::get<Scanner>(context), first, last);
    const std::size_t end = input.begin == input.end ? input.end : static_cast<const Derived*>(this)->end_in(input);
    if (end <= input.begin || end > input.end) return false;
    first += end - input.begin;
    return true;
  }
};

struct Word : TokenParser<Word> {
  std::size_t end_in(const Input& input) const {
    const Token token = input.first_token();
    return token.kind == Kind::word && !text::is_digit(input.front()) ? token.end : input.begin;
  }
};

struct Keyword : TokenParser<Keyword> {
  explicit constexpr Keyword(std::string_view keyword) : word(keyword) {}
  std::size_t end_in(const Input& input) const {
    const Token token = input.first_token();
    return input.tokens.is_word(token, word) ? token.end : input.begin;
  }
  std::string_view word;
};

/// A closed name in quotes or back-ticks.
struct QuotedName : TokenParser<QuotedName> {
  std::size_t end_in(const Input& input) const {
    const Token token = input.first_token();
    const std::string_view text = input.tokens.text_of(token);
    const bool is_name = token.kind == Kind::quoted && text.front() != '\'' && text.size() > 2;
    return is_name && text.back() == text.front() ? token.end : input.begin;
  }
};

/// Round or square brackets with all that is in them.
struct Brackets : TokenParser<Brackets> {
  std::size_t end_in(const Input& input) const {
    const Tokens& tokens = input.tokens;
    std::size_t depth = 0;
    for (Token token = input.first_token(); token.begin < input.end; token = input.tokens.next()) {
      if (tokens.is_mark(token, '(') || tokens.is_mark(token, '[')) ++depth;
      if ((tokens.is_mark(token, ')') || tokens.is_mark(token, ']')) && depth > 0 && --depth == 0) return token.end;
      if (depth == 0) break;
    }
    return input.begin;
  }
};

struct Address : TokenParser<Address> {
  std::size_t end_in(const Input& input) const {
    if (input.front() != '%') return input.begin;
    std::size_t end = input.begin + 1;
    while (end < input.end && is_of_address(input.tokens.text()[end])) ++end;
    return end > input.begin + 1 ? end : input.begin;
  }
  static bool is_of_address(char c) {
    return text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'Z') || c == '.' || c == '*' || c == '_' ||
           c == '\\';
  }
};

/// All up to the end of the declaration.
struct Rest : TokenParser<Rest> {
  std::size_t end_in(const Input& input) const { return input.end; }
};

template <class Context>
std::string_view matched(const Context& context) {
  const auto& range = x3::_attr(context);
  std::string_view text(range.begin(), static_cast<std::size_t>(range.end() - range.begin()));
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
  while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
  return text;
}

const auto add_name = [](const auto& context) {
  std::string_view name = matched(context);
  const bool quoted = name.front() == '"' || name.front() == '`';
  if (quoted && name.find(name.front(), 1) == name.size() - 1) name = name.substr(1, name.size() - 2);
  x3::get<Result>(context).names.push_back(name);
};
const auto set_address = [](const auto& context) { x3::get<Result>(context).address = matched(context); };
const auto set_type = [](const auto& context) { x3::get<Result>(context).type = matched(context); };
const auto set_initial = [](const auto& context) { x3::get<Result>(context).initial = matched(context); };

const auto name = Word() | QuotedName();
const auto path = name >> *('.' >> name);
const auto location = x3::raw[Address()][set_address] | path;
const auto wrapper = (Keyword("POINTER") | Keyword("REFERENCE")) >> Keyword("TO") | Keyword("REF_TO") |
                     Keyword("ARRAY") >> Brackets() >> Keyword("OF");
const auto plain_type = Brackets() | path >> *Brackets();
const auto type = x3::raw[*wrapper >> plain_type][set_type] >> -(Keyword("R_EDGE") | Keyword("F_EDGE"));
const auto initial = (x3::lit(":=") | x3::lit("REF=")) >> x3::raw[Rest()][set_initial];
const auto declaration = x3::raw[path][add_name] % ',' >> -(Keyword("AT") >> location) >> ':' >> type >> -initial
                         >> x3::eoi;

}  // namespace

bool parse_declaration(Tokens& tokens, text::Span range, ParsedDeclaration& parsed) {
  parsed.names.clear();
  parsed.address = parsed.type = parsed.initial = {};
  const char* first = tokens.text().data() + range.begin;
  const char* const last = tokens.text().data() + range.end;
  return x3::phrase_parse(first, last, x3::with<Scanner>(tokens)[x3::with<Result>(parsed)[declaration]],
                          Skipped(tokens));
}

}  // namespace symplant::read::st
