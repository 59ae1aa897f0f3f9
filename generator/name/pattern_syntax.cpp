// Parses patterns of names by Boost.Spirit X3.
#include "name/pattern_syntax.hpp"

#include <algorithm>
#include <boost/fusion/include/adapt_struct.hpp>
#include <boost/spirit/home/x3.hpp>

BOOST_FUSION_ADAPT_STRUCT(symplant::name::syntax::Group, alternatives)

namespace symplant::name::syntax {
namespace {

constexpr std::size_t kMostBytes = 1000;
constexpr int kMostDepth = 16;

const auto plain = (~x3::char_("{}()|*\\")) | ('\\' >> x3::char_);
const x3::rule<struct TextRule, Text> text_rule = "text";
const auto text_rule_def = +plain;
const auto take_braces = [](auto& context) {
  const auto& range = x3::_attr(context);
  x3::_val(context) = Braces{{range.begin(), static_cast<std::size_t>(range.end() - range.begin())}};
};
const x3::rule<struct BracesRule, Braces> braces = "braces";
const auto braces_def = '{' >> x3::raw[*(~x3::char_("{}"))][take_braces] >> '}';
const auto any = '*' >> x3::attr(Any{});
const x3::rule<struct SequenceRule, Sequence> sequence = "sequence";
const x3::rule<struct GroupRule, Group> group = "group";
const x3::rule<struct ListRule, std::vector<Sequence>> list = "list";
const auto list_def = sequence % '|';
const auto group_def = '(' >> list >> ')';
const auto sequence_def = *(text_rule | braces | any | group);
BOOST_SPIRIT_DEFINE(text_rule, braces, sequence, group, list)

int depth_of(std::string_view pattern) {
  int depth = 0;
  int most = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '\\')
      ++i;
    else if (pattern[i] == '(')
      most = std::max(most, ++depth);
    else if (pattern[i] == ')')
      --depth;
  }
  return most;
}

/// Why parsing stopped.
PatternFault fault_at(std::string_view pattern, std::size_t offset) {
  if (offset == pattern.size()) return {offset, "the pattern ends early; complete it"};
  switch (pattern[offset]) {
    case '{':
      return {offset, "`{` without `}`; close the field, or write `\\{` for the character"};
    case '}':
      return {offset, "`}` without `{`; remove it, or write `\\}` for the character"};
    case '(':
      return {offset, "`(` without `)`; close the group, or write `\\(` for the character"};
    case ')':
      return {offset, "`)` without `(`; remove it, or write `\\)` for the character"};
    case '|':
      return {offset, "`|` outside of parentheses; write `(A|B)`, or `\\|` for the character"};
    default:
      return {offset, "`\\` without a character after it; remove it"};
  }
}

}  // namespace

base::Result<Group, PatternFault> parse(std::string_view pattern, bool open) {
  if (pattern.size() > kMostBytes) {
    return PatternFault{0, "the pattern has more than " + std::to_string(kMostBytes) + " bytes; shorten it"};
  }
  if (depth_of(pattern) > kMostDepth) {
    return PatternFault{0, "more than " + std::to_string(kMostDepth) + " groups in each other; simplify the pattern"};
  }
  Group whole;
  const char* at = pattern.data();
  const char* const end = at + pattern.size();
  bool parsed = false;
  if (open) {
    parsed = x3::parse(at, end, list, whole.alternatives);
  } else {
    parsed = x3::parse(at, end, sequence, whole.alternatives.emplace_back());
  }
  if (!parsed || at != end) return fault_at(pattern, static_cast<std::size_t>(at - pattern.data()));
  return whole;
}

}  // namespace symplant::name::syntax
