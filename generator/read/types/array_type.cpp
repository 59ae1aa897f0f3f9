// The grammar of declarations of arrays, by Boost.Spirit X3.
#include "read/types/array_type.hpp"

#include <boost/spirit/home/x3.hpp>

#include "read/types/data_types.hpp"

namespace symplant::read {
namespace {

namespace x3 = boost::spirit::x3;

constexpr std::size_t kMostDimensions = 8;
constexpr std::size_t kLongestType = 1'000;

const x3::int_parser<std::int64_t> kBound;

std::string_view without_blanks_around(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::uint64_t ArrayType::count(std::uint64_t limit) const {
  std::uint64_t count = 1;
  for (const Dimension& dimension : dimensions) {
    const std::uint64_t more = static_cast<std::uint64_t>(dimension.last) - static_cast<std::uint64_t>(dimension.first);
    if (more >= limit || (more + 1) * count >= limit) return limit;
    count *= more + 1;
  }
  return count;
}

std::optional<ArrayType> parse_array_type(std::string_view text) {
  if (text.size() > kLongestType) return std::nullopt;
  ArrayType array;
  std::int64_t first = 0;
  const auto begin = [&](auto& context) { first = x3::_attr(context); };
  const auto add = [&](auto& context, std::int64_t last) {
    x3::_pass(context) = last >= first && array.dimensions.size() < kMostDimensions;
    array.dimensions.push_back({first, last});
  };
  const auto end = [&](auto& context) { add(context, x3::_attr(context)); };
  const auto length = [&](auto& context) {
    first = 0;
    const std::int64_t count = x3::_attr(context);
    add(context, count > 0 ? count - 1 : -1);
  };
  const auto element = [&](auto& context) {
    const auto& match = x3::_attr(context);
    array.element = without_blanks_around({match.begin(), match.size()});
  };
  const auto range = kBound[begin] >> ".." >> kBound[end];
  const auto declared = x3::no_case["array"] >> '[' >> range % ',' >> ']' >> x3::no_case["of"] >>
                        x3::raw[x3::no_skip[+x3::char_]][element];
  const auto short_form = x3::raw[+(x3::char_ - '(' - '[')][element] >>
                          ('(' >> range % ',' >> ')' | '[' >> (range % ',' | kBound[length] % ',') >> ']');
  const char* at = text.data();
  const char* const last = at + text.size();
  bool found = x3::phrase_parse(at, last, declared, x3::ascii::blank) && at == last;
  if (!found) {
    array = {};
    at = text.data();
    found = x3::phrase_parse(at, last, short_form, x3::ascii::blank) && at == last;
  }
  const auto type = found ? data_type(array.element) : std::nullopt;
  if (!type) return std::nullopt;
  array.type = *type;
  return array;
}

}  // namespace symplant::read
