// Parses conditions with Boost.Spirit X3; only this file includes it.
#define BOOST_SPIRIT_X3_UNICODE
#include <boost/regex/pending/unicode_iterator.hpp>
#include <boost/spirit/home/x3.hpp>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "symplant/condition/expression.hpp"

/// The name of a rule with an action in messages: the rule's name.
template <class Subject, class Action>
struct boost::spirit::x3::get_info<boost::spirit::x3::action<Subject, Action>> {
  using result_type = std::string;
  std::string operator()(const action<Subject, Action>& parser) const { return what(parser.subject); }
};

namespace symplant::condition {
namespace {

namespace x3 = boost::spirit::x3;
namespace unicode = x3::unicode;

using CodePoints = boost::u8_to_u32_iterator<const char*>;
using Piece = boost::iterator_range<CodePoints>;

struct TextBegin;  // tag: the begin of the text

std::string_view text_of(const Piece& piece) {
  const char* begin = piece.begin().base();
  return {begin, static_cast<std::size_t>(piece.end().base() - begin)};
}

template <class Context>
Location location_of(const Context& context, std::string_view text) {
  const char* begin = x3::get<TextBegin>(context);
  return {static_cast<std::size_t>(text.data() - begin), text.size()};
}

/// Removes the quotes of a quoted name, and replaces each doubled quote by a single one.
std::string unquoted(std::string_view text) {
  std::string result;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    result += text[i];
    if (text[i] == '\'') ++i;
  }
  return result;
}

// Messages use these names for what is expected.
const x3::rule<struct ConditionTag, Expression> condition = "a name, `not` or `(`";
const x3::rule<struct BothTag, Expression> both = "a name, `not` or `(`";
const x3::rule<struct PartTag, Expression> part = "a name, `not` or `(`";
const x3::rule<struct PrimaryTag, Expression> primary = "a name or `(`";
const x3::rule<struct TestTag, Expression> test = "a name";
const x3::rule<struct ComparedTag, Expression> compared = "a name";
const x3::rule<struct AloneTag, Expression> alone = "a name";
const x3::rule<struct LeftTag, Operand> left = "a name";
const x3::rule<struct RightTag, Operand> right = "a number";
const x3::rule<struct NameTag, Name> name = "a name";
const x3::rule<struct LevelTag, Name> level = "a name";
const x3::rule<struct PlainNameTag, Name> plain_name = "a name";
const x3::rule<struct OutputTag, Name> output = "the number of an output";
const x3::rule<struct NumberTag, Operand> number = "a number";
const x3::rule<struct CloseIndexTag> close_index = "`]`";
const x3::rule<struct CloseTag> close = "`and`, `or` or `)`";
const x3::rule<struct EndTag> end = "`and`, `or` or the end";

const auto letter = unicode::alnum | unicode::char_('_');
const auto quote = unicode::char_('\'');
const auto word_or = x3::lexeme[unicode::char_("oO") >> unicode::char_("rR") >> !letter];
const auto word_and = x3::lexeme[unicode::char_("aA") >> unicode::char_("nN") >> unicode::char_("dD") >> !letter];
const auto word_not = x3::lexeme[unicode::char_("nN") >> unicode::char_("oO") >> unicode::char_("tT") >> !letter];
const auto quoted = x3::lexeme[quote >> +((quote >> quote) | (unicode::char_ - quote)) >> quote];
const auto plain = x3::lexeme[+letter];
const auto digit = unicode::char_('0', '9');
/// Any text that may be intended as a number: Number::read decides.
const auto number_text = x3::lexeme[-(unicode::char_('+') | unicode::char_('-')) >> digit >>
                                    *((unicode::char_("eE") >> unicode::char_("+-") >> &digit) | letter |
                                      unicode::char_('#') | unicode::char_('.'))];

// Semantic actions.

const auto take = [](const auto& context) { x3::_val(context) = std::move(x3::_attr(context)); };
const auto take_name = [](const auto& context) {
  const std::string_view text = text_of(x3::_attr(context));
  x3::_val(context) = {text.front() == '\'' ? unquoted(text) : std::string(text), location_of(context, text)};
};
const auto take_number = [](const auto& context) {
  const std::string_view text = text_of(x3::_attr(context));
  auto read = Number::read(text);
  x3::_pass(context) = read.has_value();
  if (read) x3::_val(context) = {{}, {}, std::move(*read), location_of(context, text)};
};
const auto add_name = [](const auto& context) { x3::_val(context).names.push_back(std::move(x3::_attr(context))); };
/// Adds an identifier to an operand, or the number of an output.
const auto add_identifier = [](const auto& context) {
  Operand& operand = x3::_val(context);
  const Location last = x3::_attr(context).index;
  if (operand.names.empty()) operand.index.offset = last.offset;
  operand.index.length = last.offset + last.length - operand.index.offset;
  operand.names.push_back(std::move(x3::_attr(context)));
};
const auto set_output = [](const auto& context) { x3::_val(context).output = std::move(x3::_attr(context)); };
const auto add_operand = [](const auto& context) {
  x3::_val(context).operands.push_back(std::move(x3::_attr(context)));
};
template <tables::Comparison comparison>
const auto compare = [](const auto& context) {
  x3::_val(context).kind = Expression::Kind::comparison;
  x3::_val(context).comparison = comparison;
};
const auto negate = [](const auto& context) {  // two negations cancel
  Expression::Kind& kind = x3::_val(context).kind;
  kind = kind == Expression::Kind::negation ? Expression::Kind::name : Expression::Kind::negation;
};
const auto take_negated = [](const auto& context) {
  if (x3::_val(context).kind == Expression::Kind::negation) {
    x3::_val(context).children.push_back(std::move(x3::_attr(context)));
  } else {
    take(context);
  }
};
const auto add_part = [](const auto& context) { x3::_val(context).children.push_back(std::move(x3::_attr(context))); };
/// Joins several parts into one expression; a single part stays unchanged.
template <Expression::Kind kind>
const auto join = [](const auto& context) {
  Expression& all = x3::_val(context);
  all.kind = kind;
  if (all.children.size() > 1) return;
  Expression only = std::move(all.children.front());
  all = std::move(only);
};

// Grammar.

const auto comparison = x3::lexeme[x3::lit('<') >> '='][compare<tables::Comparison::less_equal>] |
                        x3::lexeme[x3::lit('>') >> '='][compare<tables::Comparison::greater_equal>] |
                        x3::lit('<')[compare<tables::Comparison::less>] |
                        x3::lit('>')[compare<tables::Comparison::greater>] |
                        x3::lit('=')[compare<tables::Comparison::equal>];

const auto level_def = x3::raw[quoted | plain][take_name];
const auto plain_name_def = x3::raw[plain][take_name];
const auto name_def = !(word_and | word_or | word_not) >> level[take];
const auto number_def = x3::raw[number_text][take_number];
const auto further_name = x3::lit('.') > level[add_name];
const auto alone_def = name[add_name] >> -(further_name >> -further_name);
const auto further_level = x3::lit('.') > level[add_identifier];
const auto output_def = plain_name[take];
const auto close_index_def = x3::lit(']');
const auto element = x3::lit('[') > output[set_output] > close_index;
const auto left_def = number[take] | (name[add_identifier] >> *further_level >> -element);
/// A name that begins with a digit is more likely a wrong number.
const auto right_def = number[take] | (!x3::lexeme[digit] >> name[add_identifier] >> *further_level >> -element);
const auto tolerance = x3::lexeme[x3::lit('+') >> '-'] > number[add_operand];
const auto compared_def = ((left[add_operand] >> comparison) > right[add_operand]) >> -tolerance;
const auto test_def = compared[take] | alone[take];
const auto primary_def = (x3::lit('(') > condition[take] > close) | test[take];
const auto part_def = (+word_not[negate] > primary[take_negated]) | primary[take];
const auto both_def = part[add_part] >> *(word_and > part[add_part]) >> x3::eps[join<Expression::Kind::all>];
const auto condition_def = both[add_part] >> *(word_or > both[add_part]) >> x3::eps[join<Expression::Kind::any>];
const auto close_def = x3::lit(')');
const auto end_def = x3::eoi;

BOOST_SPIRIT_DEFINE(condition, both, part, primary, test, compared, alone, left, right, name, level, plain_name, output,
                    number, close_index, close, end)

/// Offset of the first parenthesis that exceeds kDeepestNesting; the text's size if there is no such parenthesis.
std::size_t too_deep(std::string_view text) {
  std::size_t depth = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') in_quotes = !in_quotes;
    if (in_quotes) continue;
    if (text[i] == '(' && ++depth > kDeepestNesting) return i;
    if (text[i] == ')' && depth > 0) --depth;
  }
  return text.size();
}

bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The name, number or character at an offset, for messages.
Location token_at(std::string_view text, std::size_t offset) {
  std::size_t stop = offset;
  if (stop < text.size() && text[stop] == '\'') {
    const std::size_t closing = text.find('\'', stop + 1);
    return {offset, (closing == std::string_view::npos ? text.size() : closing + 1) - offset};
  }
  while (stop < text.size() && is_letter(text[stop])) ++stop;
  if (stop == offset && stop < text.size()) ++stop;
  return {offset, stop - offset};
}

bool has_comparison(std::string_view text) {
  bool in_quotes = false;
  for (const char c : text) {
    if (c == '\'') in_quotes = !in_quotes;
    if (!in_quotes && (c == '<' || c == '=' || c == '>')) return true;
  }
  return false;
}

/// What to do about an operator or a call of a function in a comparison; empty if there is neither at an offset.
std::string instead_of_formula(std::string_view text, std::size_t offset) {
  const char there = text[offset];
  const bool is_call = there == '(' && offset > 0 && is_letter(text[offset - 1]);
  if (!is_call && std::string_view("+-*/").find(there) == std::string_view::npos) return {};
  if (!has_comparison(text)) return {};
  return std::string("; a condition does not calculate: make the formula a value, as in ") +
         "`\"sum\": { \"is\": \"a + b\" }`, and compare that" +
         (there == '-' ? ", or put a name with `-` in single quotes" : "");
}

Fault fault_at(std::string_view text, std::size_t offset, const std::string& expected) {
  const Location index = token_at(text, offset);
  if (index.length == 0) return {index, "expected " + expected + ", but the condition ends"};
  const std::string there(text.substr(index.offset, index.length));
  if (there.front() == '\'' && (there.size() == 1 || there.back() != '\'')) {
    return {{offset, 1}, "this quote is not closed; add a `'` after the name"};
  }
  if (there == "[") return {index, "an output of a value has no comparison; compare it, as in `NAME[1] = 1`"};
  return {index, "expected " + expected + ", but found `" + there + "`" + instead_of_formula(text, offset)};
}

}  // namespace

std::variant<Expression, Fault> parse(std::string_view text) {
  if (const std::size_t deep = too_deep(text); deep < text.size()) {
    return Fault{{deep, 1}, "more than " + std::to_string(kDeepestNesting) + " nested parentheses"};
  }
  const char* begin = text.data();
  const char* last = begin + text.size();
  const auto offset = [&](CodePoints at) {
    const CodePoints stop(last, begin, last);
    x3::parse(at, stop, *unicode::space);
    return static_cast<std::size_t>(at.base() - begin);
  };
  try {
    CodePoints at(begin, begin, last);
    Expression result;
    x3::phrase_parse(at, CodePoints(last, begin, last), x3::with<TextBegin>(begin)[x3::eps > condition > end],
                     unicode::space, result);
    return result;
  } catch (const x3::expectation_failure<CodePoints>& failure) {
    return fault_at(text, offset(failure.where()), failure.which());
  } catch (const std::out_of_range&) {
    return Fault{{0, text.size()}, "the condition is not valid UTF-8"};
  }
}

}  // namespace symplant::condition
