// Parses declarations of tags in Logix projects with Boost.Spirit X3.
#include "read/rockwell/l5k_declaration.hpp"

#include <boost/range/iterator_range.hpp>
#include <boost/spirit/home/x3.hpp>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"

namespace symplant::read {

namespace {

namespace x3 = boost::spirit::x3;

constexpr std::string_view kL5kTagsEnd = "END_TAG";

std::string_view l5k_text_of(const boost::iterator_range<const char*>& range) {
  return {range.begin(), static_cast<std::size_t>(range.size())};
}

/// The end of the string in quotes that begins at `first`; `first` if it is not closed in its line.
const char* end_of_l5k_string(const char* first, const char* last) {
  const char quote = *first;
  for (const char* at = first + 1; at != last && *at != '\n' && *at != '\r'; ++at) {
    if (*at == quote) return at + 1;
    if (*at == '$' && at + 1 != last && at[1] != '\n' && at[1] != '\r') ++at;
  }
  return first;
}

/// A value that is not only text: all up to a `,`, `)` or `;` outside its brackets and strings. Counts the brackets
/// instead of calling itself, and ends at the first `;`, so that neither depth nor an unclosed bracket costs anything.
struct L5kValueParser : x3::parser<L5kValueParser> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class Iterator, class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&, Attribute&) const {
    x3::skip_over(first, last, context);
    std::size_t depth = 0;
    for (Iterator at = first; at != last; ++at) {
      const char c = *at;
      if (c == '"' || c == '\'') {
        const Iterator end = end_of_l5k_string(at, last);
        if (end == at && c == '"') return false;
        if (end != at) at = end - 1;
      } else if (c == '(' || c == '[') {
        ++depth;
      } else if (c == ';' || (depth == 0 && (c == ',' || c == ')'))) {
        const bool good = depth == 0 && at != first;
        if (good) first = at;
        return good;
      } else if (c == ')' || c == ']') {
        depth -= depth == 0 ? 0 : 1;
      }
    }
    return false;
  }
};

/// A string in double quotes.
struct L5kStringParser : x3::parser<L5kStringParser> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class Iterator, class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&, Attribute&) const {
    x3::skip_over(first, last, context);
    if (first == last || *first != '"') return false;
    const Iterator end = end_of_l5k_string(first, last);
    const bool closed = end != first;
    first = end;
    return closed;
  }
};

const auto kL5kBlanks = x3::standard::char_(" \t\r\n") |
                        (x3::lit("(*") >> *(x3::standard::char_ - x3::lit("*)")) >> (x3::lit("*)") | x3::eoi));
const auto kL5kInnerColon = x3::lit(':') >> &(x3::standard::char_ - x3::standard::char_(" \t\r\n="));

/// Where an invalid declaration ends: behind a line that ends with `;`, or before END_TAG.
std::size_t end_of_invalid_l5k(std::string_view text, std::size_t at) {
  LineReader lines(text, at);
  Line line;
  while (lines.next(line)) {
    const std::string_view content = without_blanks(line.text);
    if (content.starts_with(kL5kTagsEnd) && line.begin != at) return line.begin;
    if (content.ends_with(';')) return line.begin + line.text.size();
  }
  return text.size();
}

}  // namespace

std::size_t skip_l5k_blanks(std::string_view text, std::size_t at) {
  const char* first = text.data() + at;
  x3::parse(first, text.data() + text.size(), *kL5kBlanks);
  return static_cast<std::size_t>(first - text.data());
}

std::size_t parse_l5k_declaration(std::string_view text, std::size_t at, L5kDeclaration& declaration) {
  auto& attributes = declaration.attributes;
  declaration.name = declaration.type = declaration.target = {};
  attributes.clear();
  const auto into = [](std::string_view& cell) {
    return [&cell](auto& context) { cell = l5k_text_of(x3::_attr(context)); };
  };
  const auto begin_attribute = [&](auto& context) { attributes.push_back({l5k_text_of(x3::_attr(context)), {}, 0}); };
  const auto add_string = [&](auto& context) {
    const std::string_view quoted = l5k_text_of(x3::_attr(context));
    const std::size_t open = quoted.find('"');
    attributes.back().strings.push_back(quoted.substr(open + 1, quoted.size() - open - 2));
  };
  const auto is_no_text = [&](auto&) { attributes.back().strings.clear(); };
  const auto end_attribute = [&](auto& context) {
    attributes.back().end = static_cast<std::size_t>(x3::_attr(context).end() - text.data());
  };

  const auto name =
      x3::raw[x3::lexeme[+((x3::standard::char_ - x3::standard::char_(" \t\r\n(),;:\"")) | kL5kInnerColon)]];
  const auto operand = x3::raw[x3::lexeme[+(x3::standard::char_ - x3::standard::char_(" \t\r\n();\""))]];
  const auto type =
      x3::raw[x3::lexeme[+((x3::standard::char_ - x3::standard::char_(" \t\r\n();:\"")) | kL5kInnerColon)]];
  const auto strings = +x3::raw[L5kStringParser{}][add_string] >> &(x3::lit(',') | ')');
  const auto value = strings | x3::omit[L5kValueParser{}][is_no_text];
  const auto attribute = x3::raw[name[begin_attribute] >> ":=" >> value][end_attribute];
  const auto grammar = name[into(declaration.name)] >>
                       ((x3::lexeme["OF" >> &x3::standard::char_(" \t\r\n")] >> operand[into(declaration.target)]) |
                        (':' >> type[into(declaration.type)])) >>
                       -('(' >> -(attribute % ',') >> ')') >>
                       -(":=" >> (L5kValueParser{} % (',' >> x3::omit[name] >> ":="))) >> ';';

  const char* first = text.data() + at;
  declaration.valid =
      x3::phrase_parse(first, text.data() + text.size(), grammar, kL5kBlanks, x3::skip_flag::dont_post_skip);
  return declaration.valid ? static_cast<std::size_t>(first - text.data()) : end_of_invalid_l5k(text, at);
}

}  // namespace symplant::read
