// Resolves the alarms of the description.
#include "elements/alarm/resolve.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::Pointer;
using description::ticked;

class AlarmResolver {
 public:
  AlarmResolver(PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {}

  void run() {
    const std::vector<description::GivenAlarm>& given = plant_.description->alarms;
    for (std::size_t i = 0; i < given.size(); ++i) resolve(given[i], Pointer("/alarms") / i);
  }

 private:
  bool is_shown(const Value& value) const { return value.row.trace != 0; }

  void resolve(const description::GivenAlarm& given, const Pointer& here) {
    const std::string& text = given.of;
    const bool is_pattern = text::is_pattern(text);
    const auto fits = [&](std::string_view name) {
      return is_pattern ? text::matches_pattern(name, text) : text::equal_ignoring_case(name, text);
    };
    bool any = false;
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (plant_.symbols[i].direction != tables::Direction::operation || !fits(plant_.symbols[i].name())) continue;
      add({.symbol = i}, given.priority);
      any = true;
    }
    for (std::uint32_t i = 0; i < plant_.values.size(); ++i) {
      if (!is_shown(plant_.values[i]) || !fits(plant_.values[i].name)) continue;
      add({.value = i}, given.priority);
      any = true;
    }
    if (any) return;
    if (is_pattern) {
      faults_.warn(here, ticked(text) + " matches no operation and no value", FaultKind::matches_nothing);
    } else {
      report_name(text, here);
    }
  }

  /// Says what a name is that is no alarm.
  void report_name(const std::string& text, const Pointer& here) {
    const auto has_name = [&](const auto& one) {
      if constexpr (requires { one.name(); }) {
        return text::equal_ignoring_case(one.name(), text);
      } else {
        return text::equal_ignoring_case(one.name, text);
      }
    };
    if (std::any_of(plant_.symbols.begin(), plant_.symbols.end(), has_name)) {
      return faults_.add(here,
                         ticked(text) + " is an event, which the program reads; an alarm is an operation or a value");
    }
    if (std::any_of(plant_.values.begin(), plant_.values.end(), has_name)) {
      return faults_.add(here, ticked(text) + " has `\"trace\": false`, so nothing shows it; remove that");
    }
    const std::size_t symbols = plant_.symbols.size();
    const std::string_view nearest =
        faults_.nearest(text, symbols + plant_.values.size(), [&](std::size_t i) -> std::string_view {
          if (i >= symbols) return plant_.values[i - symbols].name;
          return plant_.symbols[i].direction == tables::Direction::operation ? plant_.symbols[i].name()
                                                                             : std::string_view();
        });
    faults_.add(here, description::missing("operation or value " + ticked(text), nearest), FaultKind::unknown_name);
  }

  /// Of several entries that name one alarm, the last one with a priority decides.
  void add(const Alarm& alarm, std::optional<tables::AlarmPriority> priority) {
    const auto same = [&](const Alarm& other) { return other.symbol == alarm.symbol && other.value == alarm.value; };
    auto known = std::find_if(plant_.alarms.begin(), plant_.alarms.end(), same);
    if (known == plant_.alarms.end()) known = plant_.alarms.insert(known, alarm);
    known->priority = priority.value_or(known->priority);
  }

  PlantModel& plant_;
  description::Faults& faults_;
};

}  // namespace

void resolve_alarms(PlantModel& plant, description::Faults& faults) { AlarmResolver(plant, faults).run(); }

std::vector<Alarm> alarms_by_output(const PlantModel& plant) {
  std::vector<Alarm> all;
  for (const Alarm& alarm : plant.alarms) {
    if (alarm.symbol != tables::kNone) {
      all.push_back(alarm);
      continue;
    }
    const tables::ValueRow& row = plant.values[alarm.value].row;
    for (std::uint32_t i = 0; i < row.outputs; ++i) all.push_back({tables::kNone, row.output + i, alarm.priority});
  }
  return all;
}

}  // namespace symplant::model
