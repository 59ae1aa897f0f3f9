// Cuts names into levels, and finds the fault of a name that does not have the levels of its rule.
#define BOOST_SPIRIT_X3_UNICODE
#include "name/level_rule.hpp"

#include <algorithm>
#include <boost/spirit/home/support/char_encoding/unicode.hpp>
#include <utility>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::name {
namespace {

constexpr auto kAsciiAlnum = [] {
  std::array<bool, 256> alnum{};
  for (unsigned c = '0'; c <= '9'; ++c) alnum[c] = true;
  for (unsigned c = 'A'; c <= 'Z'; ++c) alnum[c] = alnum[c | 0x20U] = true;
  return alnum;
}();

const DirectionWord* direction_word(const LevelRule& rule, std::string_view text) {
  for (const DirectionWord& known : rule.directions) {
    if (text::equal_ignoring_case(known.word, text)) return &known;
  }
  return nullptr;
}

LevelReading& faulty(LevelReading& reading, NameFault fault, std::string_view where) {
  reading.fault = fault;
  reading.where = where;
  reading.direction = nullptr;
  return reading;
}

/// Looks for the direction of a name that has all levels.
void read_direction(const LevelRule& rule, LevelReading& reading) {
  const std::string_view text = reading.of(Level::direction);
  if (text.empty()) return;  // no level of a name is empty
  reading.direction = direction_word(rule, text);
  if (reading.direction == nullptr) faulty(reading, NameFault::direction_unknown, text);
}

/// Cuts a name of ASCII letters and digits with the levels of the rule, as most names are. False for all other names.
bool cut_plain(const LevelRule& rule, std::string_view name, LevelReading& reading) {
  const char* at = name.data();
  const char* const end = at + name.size();
  for (const Level& level : rule.levels) {
    const char* const begin = at;
    while (at != end && kAsciiAlnum[static_cast<unsigned char>(*at)]) ++at;
    if (at == begin) return false;
    reading.text[static_cast<std::size_t>(level)] = {begin, static_cast<std::size_t>(at - begin)};
    if (&level == &rule.levels.back()) break;
    if (at == end || *at != rule.separator) return false;
    ++at;
  }
  return at == end;
}

/// The first character that no level may hold; empty without one.
std::string_view illegal_character(const LevelRule& rule, std::string_view name) {
  for (std::size_t at = 0; at < name.size();) {
    const text::CodePoint character = text::code_point_at(name, at);
    const bool legal = character.value < 0x80 ? kAsciiAlnum[character.value] ||
                                                    character.value == static_cast<unsigned char>(rule.separator)
                                              : boost::spirit::char_encoding::unicode::isalnum(character.value);
    if (!legal) return name.substr(at, character.length);
    at += character.length;
  }
  return {};
}

std::vector<std::string_view> parts_of(const LevelRule& rule, std::string_view name) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(name.find(rule.separator, begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    if (end == name.size()) return parts;
    begin = end + 1;
  }
}

/// First and last of the surplus levels: those that move the direction back, if exactly one level holds a direction
/// word; else those after the last level of the rule.
std::pair<std::size_t, std::size_t> surplus_levels(const LevelRule& rule, const std::vector<std::string_view>& parts) {
  const std::size_t wanted = rule.levels.size();
  const auto direction = std::find(rule.levels.begin(), rule.levels.end(), Level::direction);
  const auto index = static_cast<std::size_t>(direction - rule.levels.begin());
  std::size_t found = parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (direction_word(rule, parts[i]) == nullptr) continue;
    if (found != parts.size()) return {wanted, parts.size() - 1};
    found = i;
  }
  if (found > index && found - index <= parts.size() - wanted) return {index, found - 1};
  return {wanted, parts.size() - 1};
}

/// Cuts any name.
void cut(const LevelRule& rule, std::string_view name, LevelReading& reading) {
  reading = {};
  if (const std::string_view bad = illegal_character(rule, name); !bad.empty()) {
    faulty(reading, NameFault::illegal_character, bad);
    return;
  }
  const std::vector<std::string_view> parts = parts_of(rule, name);
  reading.levels = static_cast<std::uint32_t>(parts.size());
  const auto is_empty = [](std::string_view part) { return part.empty(); };
  const auto empty = static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), is_empty));
  const std::size_t wanted = rule.levels.size();
  if (empty != 0 && (parts.size() == wanted || parts.size() - empty == wanted)) {
    faulty(reading, NameFault::empty_level, *std::find_if(parts.begin(), parts.end(), is_empty));
  } else if (parts.size() < wanted) {
    faulty(reading, NameFault::wrong_number_of_levels, name);
  } else if (parts.size() > wanted) {
    const auto [first, last] = surplus_levels(rule, parts);
    const char* const end = parts[last].data() + parts[last].size();
    faulty(reading, NameFault::wrong_number_of_levels,
           {parts[first].data(), static_cast<std::size_t>(end - parts[first].data())});
  } else {
    for (std::size_t i = 0; i < wanted; ++i) reading.text[static_cast<std::size_t>(rule.levels[i])] = parts[i];
  }
}

}  // namespace

LevelReading read_levels(const LevelRule& rule, std::string_view name) {
  LevelReading reading;
  if (cut_plain(rule, name, reading)) {
    reading.levels = static_cast<std::uint32_t>(rule.levels.size());
  } else {
    cut(rule, name, reading);
  }
  if (reading.fault == NameFault::none) read_direction(rule, reading);
  return reading;
}

}  // namespace symplant::name
