// Proposes values and signals for a list.
#include "elements/value/skeleton.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_set>

#include "elements/material/part_words.hpp"
#include "text/ascii.hpp"
#include "text/name_words.hpp"

namespace symplant::emit {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostValues = 12;

/// What a number with a word in its name most likely is.
struct KindOfWord {
  std::string_view word;
  std::string_view entry;  ///< of `values`
};
constexpr auto kLevel = R"({"unit": "l", "min": 0, "max": 100, "integral": "0"})";
constexpr auto kTemperature = R"({"unit": "degC", "start": 20, "lag": "20", "time": "60s"})";
constexpr auto kSpeed = R"({"unit": "m/s", "ramp": "0", "up": 1})";
constexpr auto kPosition = R"({"unit": "mm", "integral": "0"})";
constexpr auto kWeight = R"({"unit": "kg", "min": 0, "integral": "0"})";
constexpr auto kQuick = R"({"lag": "0", "time": "1s"})";
constexpr auto kParameter = R"({"start": 0})";
constexpr auto kKinds = std::to_array<KindOfWord>({
    {"LEVEL", kLevel},       {"LVL", kLevel},         {"FILL", kLevel},
    {"VOLUME", kLevel},      {"TEMP", kTemperature},  {"TEMPERATURE", kTemperature},
    {"SPEED", kSpeed},       {"VELOCITY", kSpeed},    {"VELO", kSpeed},
    {"RPM", kSpeed},         {"FREQ", kSpeed},        {"FREQUENCY", kSpeed},
    {"POS", kPosition},      {"POSITION", kPosition}, {"ANGLE", kPosition},
    {"ENC", kPosition},      {"ENCODER", kPosition},  {"DIST", kPosition},
    {"DISTANCE", kPosition}, {"WEIGHT", kWeight},     {"MASS", kWeight},
    {"PRESS", kQuick},       {"PRESSURE", kQuick},    {"FLOW", kQuick},
    {"CURR", kQuick},        {"CURRENT", kQuick},     {"VOLT", kQuick},
    {"VOLTAGE", kQuick},     {"TORQUE", kQuick},
});

/// The entry for the first word of a name that says what it is. Empty if no word says it.
std::string_view entry_of_words(std::string_view name) {
  std::string_view entry;
  text::any_word(name, [&](std::string_view word) {
    const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                    [&](const KindOfWord& kind) { return text::equal_ignoring_case(kind.word, word); });
    if (found != kKinds.end()) entry = found->entry;
    return found != kKinds.end();
  });
  return entry;
}

/// Of the task, else of the whole name.
Json entry_of(const model::Symbol& symbol) {
  std::string_view entry = entry_of_words(symbol.reading.task());
  if (entry.empty()) entry = entry_of_words(symbol.name());
  return Json::parse(entry.empty() ? std::string_view(kParameter) : entry);
}

bool is_free_number(const model::PlantModel& plant, const model::Symbol& symbol) {
  return symbol.direction == tables::Direction::event && symbol.type != tables::DataType::boolean &&
         symbol.reading.is_named() && !model::is_driven(plant, symbol);
}

/// Letters, digits and `_`, not first a digit: what a name in a description needs no quotes for.
bool is_plain(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !name.empty() && !(name.front() >= '0' && name.front() <= '9') && std::all_of(name.begin(), name.end(), fits);
}

/// `L_S1_TANK.level` for L_S1_TANK_I_LEVEL, unless that is the name of something else or a word that formulas have.
std::string value_name(const model::PlantModel& plant, const model::Symbol& symbol) {
  static constexpr std::array<std::string_view, 5> kWords{"MOVING", "PART", "PARTS", "WEIGHT", "CODE"};
  const std::string path(symbol.reading.device_path());
  std::string task = text::to_lower(symbol.reading.task());
  if (text::to_lower(symbol.name()).find(task) == std::string::npos) task = "number";  // the naming rule made it up
  if (!is_plain(path) || !is_plain(task)) return {};
  const auto same = [&](std::string_view word) { return text::equal_ignoring_case(word, task); };
  const bool taken = std::any_of(kWords.begin(), kWords.end(), same) ||
                     std::any_of(plant.units.begin(), plant.units.end(), [&](const model::Unit& unit) {
                       return text::equal_ignoring_case(unit.path, path) &&
                              std::any_of(unit.states.begin(), unit.states.end(),
                                          [&](const model::State& state) { return same(state.name); });
                     });
  return path + "." + task + (taken ? "_value" : "");
}

}  // namespace

Json proposed_values(const model::PlantModel& plant, std::size_t& left_out) {
  left_out = 0;
  if (!plant.values.empty() || !plant.signals.empty()) return nullptr;
  Json values = Json::object();
  Json signals = Json::object();
  std::unordered_set<std::string> shapes;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!is_free_number(plant, symbol)) continue;
    const std::string name = value_name(plant, symbol);
    const bool shown = values.size() < kMostValues && is_plain(symbol.name()) && !name.empty() &&
                       !values.contains(name) && shapes.insert(text::without_numbers(symbol.name(), '#')).second;
    if (!shown) {
      ++left_out;
      continue;
    }
    values[name] = entry_of(symbol);
    signals[std::string(symbol.name())] = name;
  }
  if (values.empty()) return nullptr;
  return {{"values", values}, {"signals", signals}};
}

}  // namespace symplant::emit
