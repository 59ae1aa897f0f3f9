// Resolves the alarms of the description.
#include "elements/alarm/resolve.hpp"

#include <algorithm>
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
    const std::vector<std::string>& given = plant_.description->alarms;
    for (std::size_t i = 0; i < given.size(); ++i) resolve(given[i], Pointer("/alarms") / i);
  }

 private:
  bool is_shown(const Value& value) const { return value.row.trace != 0; }

  void resolve(const std::string& text, const Pointer& here) {
    const bool is_pattern = text::is_pattern(text);
    const auto fits = [&](std::string_view name) {
      return is_pattern ? text::matches_pattern(name, text) : text::equal_ignoring_case(name, text);
    };
    bool any = false;
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (plant_.symbols[i].direction != tables::Direction::operation || !fits(plant_.symbols[i].name())) continue;
      add({.symbol = i});
      any = true;
    }
    for (std::uint32_t i = 0; i < plant_.values.size(); ++i) {
      if (!is_shown(plant_.values[i]) || !fits(plant_.values[i].name)) continue;
      add({.value = i});
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

  void add(const Alarm& alarm) {
    if (std::find(plant_.alarms.begin(), plant_.alarms.end(), alarm) == plant_.alarms.end())
      plant_.alarms.push_back(alarm);
  }

  PlantModel& plant_;
  description::Faults& faults_;
};

}  // namespace

void resolve_alarms(PlantModel& plant, description::Faults& faults) { AlarmResolver(plant, faults).run(); }

}  // namespace symplant::model
