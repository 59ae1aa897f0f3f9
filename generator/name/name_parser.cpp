// Parses names with Boost.Spirit X3: levels of letters and digits, separated by the rule's separator.
#define BOOST_SPIRIT_X3_UNICODE
#include "name/name_parser.hpp"

#include <algorithm>
#include <array>
#include <boost/regex/pending/unicode_iterator.hpp>
#include <boost/spirit/home/x3.hpp>
#include <utility>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::name {
namespace {

namespace x3 = boost::spirit::x3;

using CodePoints = boost::u8_to_u32_iterator<const char*>;
using Piece = boost::iterator_range<CodePoints>;

std::string_view text_of(const Piece& piece) {
  const char* begin = piece.begin().base();
  return {begin, static_cast<std::size_t>(piece.end().base() - begin)};
}

const DirectionWord* direction_word(const NamingRule& rule, std::string_view text) {
  for (const DirectionWord& word : rule.directions) {
    if (text::equal_ignoring_case(word.word, text)) return &word;
  }
  return nullptr;
}

/// First and last of the surplus levels: those that move the direction back, if exactly one level holds a direction
/// word; else those after the last level of the rule.
std::pair<std::size_t, std::size_t> surplus_levels(const NamingRule& rule, const std::vector<Piece>& pieces) {
  const std::size_t wanted = rule.levels.size();
  const auto direction = std::find(rule.levels.begin(), rule.levels.end(), Level::direction);
  const auto index = static_cast<std::size_t>(direction - rule.levels.begin());
  std::size_t found = pieces.size();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (direction_word(rule, text_of(pieces[i])) == nullptr) continue;
    if (found != pieces.size()) return {wanted, pieces.size() - 1};
    found = i;
  }
  if (found > index && found - index <= pieces.size() - wanted) return {index, found - 1};
  return {wanted, pieces.size() - 1};
}

/// Reads the levels of a name. Their number must be that of the rule, and none may be empty.
void read_levels(const NamingRule& rule, const std::vector<std::string_view>& levels, NameReading& reading) {
  reading.levels = static_cast<std::uint32_t>(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (rule.levels[i] != Level::direction) {
      reading.set(rule.levels[i], levels[i]);
      continue;
    }
    const DirectionWord* found = direction_word(rule, levels[i]);
    if (found == nullptr) return reading.set_fault(NameFault::direction_not_io, levels[i]);
    reading.direction = found->direction;
  }
}

constexpr auto kAsciiAlnum = [] {
  std::array<bool, 256> alnum{};
  for (unsigned c = '0'; c <= '9'; ++c) alnum[c] = true;
  for (unsigned c = 'A'; c <= 'Z'; ++c) alnum[c] = alnum[c | 0x20U] = true;
  return alnum;
}();

/// Splits a name of ASCII letters and digits that has the levels of the rule, none of them empty, as most names do.
/// Returns false for all other names, which the grammar parses; for these names it gives the same result.
bool cut_plain(const NamingRule& rule, std::string_view name, std::vector<std::string_view>& levels) {
  levels.resize(rule.levels.size());
  const char* at = name.data();
  const char* const end = at + name.size();
  for (std::string_view& level : levels) {
    const char* const begin = at;
    while (at != end && kAsciiAlnum[static_cast<unsigned char>(*at)]) ++at;
    if (at == begin) return false;
    level = {begin, static_cast<std::size_t>(at - begin)};
    if (&level == &levels.back()) return at == end;
    if (at == end || static_cast<unsigned char>(*at) != rule.separator) return false;
    ++at;
  }
  return false;
}

}  // namespace

struct NameParser::Work {
  std::vector<Piece> pieces;
  std::vector<std::string_view> levels;
};

NameParser::NameParser(const NamingRule& rule) : rule_(rule), work_(std::make_unique<Work>()) {}
NameParser::~NameParser() = default;

NameReading NameParser::parse(std::string_view name) {
  if (!cut_plain(rule_, name, work_->levels)) return parse_by_grammar(name);
  NameReading reading(name);
  read_levels(rule_, work_->levels, reading);
  return reading;
}

NameReading NameParser::parse_by_grammar(std::string_view name) {
  std::vector<Piece>& pieces = work_->pieces;
  pieces.clear();
  const char* begin = name.data();
  const char* end = begin + name.size();
  CodePoints at(begin, begin, end);
  const CodePoints last(end, begin, end);

  // A level may be empty here, so that the message can say which one.
  const auto level = x3::raw[*x3::unicode::alnum];
  x3::parse(at, last, level % x3::unicode::char_(rule_.separator), pieces);

  NameReading reading(name);
  const auto offset = [&](const char* index) { return static_cast<std::size_t>(index - begin); };
  if (at != last) {
    const std::size_t bad = offset(at.base());
    reading.set_fault(NameFault::illegal_character, name.substr(bad, offset((++at).base()) - bad));
    return reading;
  }
  reading.levels = static_cast<std::uint32_t>(pieces.size());
  const auto text_between = [&](std::size_t from, std::size_t to) {
    const std::size_t first = offset(pieces[from].begin().base());
    return name.substr(first, offset(pieces[to].end().base()) - first);
  };

  std::size_t empty = 0;
  std::size_t first_empty = pieces.size();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].empty()) continue;
    ++empty;
    first_empty = std::min(first_empty, i);
  }
  const std::size_t wanted = rule_.levels.size();
  if (empty != 0 && (pieces.size() == wanted || pieces.size() - empty == wanted)) {
    reading.set_fault(NameFault::empty_level, text_between(first_empty, first_empty));
    return reading;
  }
  if (pieces.size() < wanted) {
    reading.set_fault(NameFault::wrong_number_of_levels, name);
    return reading;
  }
  if (pieces.size() > wanted) {
    const auto [first, last_surplus] = surplus_levels(rule_, pieces);
    reading.set_fault(NameFault::wrong_number_of_levels, text_between(first, last_surplus));
    return reading;
  }

  std::vector<std::string_view>& levels = work_->levels;
  levels.clear();
  for (const Piece& piece : pieces) levels.push_back(text_of(piece));
  read_levels(rule_, levels, reading);
  return reading;
}

}  // namespace symplant::name
