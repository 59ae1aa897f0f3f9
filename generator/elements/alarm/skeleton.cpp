// Proposes the alarms of a list.
#include "elements/alarm/skeleton.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>

#include "text/ascii.hpp"
#include "text/name_words.hpp"
#include "text/pattern.hpp"

namespace symplant::emit {
namespace {

/// In the order of English, German, French, Italian, Spanish, Norwegian.
constexpr auto kAlarmWords =
    std::to_array<std::string_view>({"ALARM", "ALARMS", "ALM",    "FAULT",   "FAULTS",  "FLT",      "ERR",     "ERROR",
                                     "HORN",  "HOOTER", "BUZZER", "SIREN",   "TROUBLE", "STOERUNG", "STÖRUNG", "FEHLER",
                                     "HUPE",  "ALARME", "DEFAUT", "ALLARME", "GUASTO",  "ALARMA",   "FALLO",   "FEIL"});
constexpr auto kOtherWords = std::to_array<std::string_view>(
    {"RESET", "RST", "ACK", "ACKN", "CLEAR", "CLR", "MUTE", "BYPASS", "TEST", "QUIT", "ENABLE", "NO"});

template <class Words>
bool has_word(std::string_view name, const Words& words) {
  return text::any_word(name, [&](std::string_view word) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view one) { return text::equal_ignoring_case(one, word); });
  });
}

bool looks_like_alarm(const model::Symbol& symbol) {
  return symbol.direction == tables::Direction::operation && has_word(symbol.name(), kAlarmWords) &&
         !has_word(symbol.name(), kOtherWords);
}

/// A pattern of names that differ in numbers and in the process only.
std::string pattern_of(const model::Symbol& symbol) {
  std::string name(symbol.name());
  const std::string_view process = symbol.reading.process();
  const std::size_t at = process.empty() ? name.npos : name.find("_" + std::string(process) + "_");
  if (at != name.npos) name.replace(at + 1, process.size(), "*");
  return text::without_numbers(name, '*');
}

/// Whether a pattern means alarms only, among the operations.
bool means_alarms_only(const model::PlantModel& plant, const std::string& pattern) {
  return std::all_of(plant.symbols.begin(), plant.symbols.end(), [&](const model::Symbol& symbol) {
    return symbol.direction != tables::Direction::operation || !text::matches_pattern(symbol.name(), pattern) ||
           looks_like_alarm(symbol);
  });
}

}  // namespace

std::vector<std::string> proposed_alarms(const model::PlantModel& plant) {
  std::vector<std::string> shapes;
  std::unordered_map<std::string, std::vector<std::string>> names;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!looks_like_alarm(symbol)) continue;
    std::string shape = pattern_of(symbol);
    std::vector<std::string>& same = names[shape];
    if (same.empty()) shapes.push_back(std::move(shape));
    same.emplace_back(symbol.name());
  }
  std::vector<std::string> proposed;
  for (const std::string& shape : shapes) {
    const std::vector<std::string>& same = names[shape];
    if (same.size() > 2 && means_alarms_only(plant, shape)) {
      proposed.push_back(shape);
    } else {
      proposed.insert(proposed.end(), same.begin(), same.end());
    }
  }
  return proposed;
}

}  // namespace symplant::emit
