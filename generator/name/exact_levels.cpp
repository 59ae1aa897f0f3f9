// Reads the pattern of an exact rule.
#include "name/exact_levels.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace symplant::name {
namespace {

struct ShownLevel {
  std::string_view field;
  std::string_view shown;  ///< in messages; empty: the words of the direction
};
constexpr std::array<ShownLevel, kLevels> kShown = {
    {{"line", "LINE"}, {"process", "PROC"}, {"device", "DEV"}, {"direction", ""}, {"task", "TASK"}}};

bool has(const LevelRule& rule, Level level) {
  return std::find(rule.levels.begin(), rule.levels.end(), level) != rule.levels.end();
}

/// Reads the next field, up to its closing brace; false if there is none, or one for the second time.
bool read_field(std::string_view pattern, std::size_t& at, LevelRule& rule) {
  const std::size_t end = pattern.find('}', at);
  if (end == pattern.npos || pattern[at] != '{') return false;
  const std::string_view field = pattern.substr(at + 1, end - at - 1);
  const auto* const known =
      std::find_if(kShown.begin(), kShown.end(), [&](const ShownLevel& level) { return level.field == field; });
  const auto level = static_cast<Level>(known - kShown.begin());
  if (known == kShown.end() || has(rule, level)) return false;
  rule.levels.push_back(level);
  rule.pattern += known->shown;
  for (const DirectionWord& word : rule.directions) {
    if (known->shown.empty()) rule.pattern.append(&word == &rule.directions.front() ? "" : "|").append(word.word);
  }
  at = end + 1;
  return true;
}

/// Whether the pattern is fields joined by one separator.
bool read_pattern(std::string_view pattern, LevelRule& rule) {
  for (std::size_t at = 0; at < pattern.size();) {
    if (!read_field(pattern, at, rule)) return false;
    if (at == pattern.size()) return true;
    if (rule.levels.size() == 1) rule.separator = pattern[at];
    if (pattern[at] != rule.separator) return false;
    rule.pattern += pattern[at++];
  }
  return false;
}

bool can_separate(char c) {
  constexpr std::string_view kSeparators = "_ -./:";
  return kSeparators.find(c) != std::string_view::npos;
}

}  // namespace

base::Result<LevelRule, NamingFault> exact_levels(const SymbolRule& rule) {
  LevelRule levels;
  for (const FieldRule& field : rule.fields) {
    if (field.field != "direction" || !field.expression.empty()) {
      return NamingFault{
          "/fields/" + field.field,
          "a level of an `exact` rule matches letters and digits; in `fields`, give only the words of `direction`"};
    }
    levels.directions = field.words;
  }
  if (rule.patterns.size() != 1 || rule.patterns.front().source != Source::name) {
    return NamingFault{"/pattern", "an `exact` rule reads names; add `\"source\": \"name\"`"};
  }
  const bool sound = read_pattern(rule.patterns.front().pattern, levels);
  if (!sound || !can_separate(levels.separator) || !has(levels, Level::device) ||
      (!has(levels, Level::task) && !rule.task)) {
    return NamingFault{"/pattern",
                       "the pattern of an `exact` rule must consist of fields and one separator between them, such as "
                       "`{line}_{process}_{device}_{direction}_{task}`"};
  }
  if (has(levels, Level::direction) == levels.directions.empty()) {
    return NamingFault{"/fields",
                       "an `exact` rule has the words of its field `{direction}` in `fields`, such as "
                       "`{ \"direction\": { \"I\": \"event\", \"O\": \"operation\" } }`"};
  }
  levels.has_path = levels.separator == '_' && levels.levels.size() > 2 && levels.levels[0] == Level::line &&
                    levels.levels[1] == Level::process && levels.levels[2] == Level::device;
  return levels;
}

}  // namespace symplant::name
