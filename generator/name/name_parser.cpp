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
void read_levels(const NamingRule& rule, std::string_view name, const std::vector<std::string_view>& levels,
                 NameReading& reading) {
  const auto offset = [&](const char* index) { return static_cast<std::size_t>(index - name.data()); };
  std::size_t device_end = 0;
  reading.levels = static_cast<std::uint32_t>(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string_view text = levels[i];
    switch (rule.levels[i]) {
      case Level::line:
        reading.line = text;
        break;
      case Level::process:
        reading.process = text;
        break;
      case Level::device:
        reading.device = text;
        device_end = offset(text.data() + text.size());
        break;
      case Level::task:
        reading.task = text;
        break;
      case Level::direction: {
        const DirectionWord* found = direction_word(rule, text);
        if (found == nullptr) {
          reading.fault = NameFault::direction_not_io;
          reading.where = {offset(text.data()), offset(text.data() + text.size())};
          return;
        }
        reading.direction = found->direction;
        break;
      }
    }
  }
  reading.device_path = name.substr(0, device_end);
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
  levels.clear();
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= name.size(); ++at) {
    if (at < name.size() && kAsciiAlnum[static_cast<unsigned char>(name[at])]) continue;
    const bool separates = at == name.size() || static_cast<unsigned char>(name[at]) == rule.separator;
    if (!separates || at == begin || levels.size() == rule.levels.size()) return false;
    levels.push_back(name.substr(begin, at - begin));
    begin = at + 1;
  }
  return levels.size() == rule.levels.size();
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
  NameReading reading;
  read_levels(rule_, name, work_->levels, reading);
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

  NameReading reading;
  const auto offset = [&](const char* index) { return static_cast<std::size_t>(index - begin); };
  if (at != last) {
    const char* bad = at.base();
    reading.fault = NameFault::illegal_character;
    reading.where = {offset(bad), offset((++at).base())};
    return reading;
  }
  reading.levels = static_cast<std::uint32_t>(pieces.size());
  const auto span_of = [&](std::size_t from, std::size_t to) {
    return text::Span{offset(pieces[from].begin().base()), offset(pieces[to].end().base())};
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
    reading.fault = NameFault::empty_level;
    reading.where = span_of(first_empty, first_empty);
    return reading;
  }
  if (pieces.size() != wanted) {
    reading.fault = NameFault::wrong_number_of_levels;
    reading.where = {0, name.size()};
    if (pieces.size() > wanted) {
      const auto [first, last_surplus] = surplus_levels(rule_, pieces);
      reading.where = span_of(first, last_surplus);
    }
    return reading;
  }

  std::vector<std::string_view>& levels = work_->levels;
  levels.clear();
  for (const Piece& piece : pieces) levels.push_back(text_of(piece));
  read_levels(rule_, name, levels, reading);
  return reading;
}

}  // namespace symplant::name
