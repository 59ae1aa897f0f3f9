// Fills the list of alarms from the records and findings of a run.
#include "symplant/panel/alarm/alarm_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "symplant/panel/picture/describe_values.hpp"
#include "symplant/panel/picture/stations.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::panel {
namespace {

using tables::AlarmPriority;
using tables::FindingKind;

constexpr std::size_t kMostMembers = 8;  ///< of a loop, in a name

/// Violations are urgent. What started on enabling was possible; the rest points to errors of the program.
AlarmPriority priority_of(FindingKind kind) {
  if (kind == FindingKind::requirement_violated) return AlarmPriority::high;
  return kind == FindingKind::started_on_enabling ? AlarmPriority::low : AlarmPriority::medium;
}

/// What a finding is of; the first members of a large loop.
std::string subject_of(const trace::FoundThing& found, const trace::PlantNames& names) {
  if (found.of.size() <= kMostMembers) return trace::name_of(found, names);
  trace::FoundThing first = found;
  first.of.resize(kMostMembers);
  return fmt::format("{} and {} more", trace::name_of(first, names), found.of.size() - kMostMembers);
}

std::string name_of(FindingKind kind, std::string_view of) {
  if (kind == FindingKind::requirement_violated) return fmt::format("requirement: {}", of);
  return fmt::format("finding: {} of {}", trace::finding_name(kind), of);
}

bool is_integer(tables::DataType type) {
  return type != tables::DataType::boolean && type != tables::DataType::real && type != tables::DataType::lreal;
}

/// A link is lost or not, whatever the plant is set back to.
bool is_of_link(const Alarm& alarm) {
  return alarm.source == Alarm::Source::finding && alarm.kind == FindingKind::link_lost;
}

}  // namespace

AlarmSources::AlarmSources(const trace::PlantNames& names, const trace::History& history, const View& view,
                           tables::Time now, AlarmList& list)
    : names_(names),
      history_(history),
      list_(list),
      lasting_(names, history),
      stations_(stations_of(names, view).of_unit),
      time_(now) {
  for (const AlarmView& alarm : view.alarms) add(alarm, view);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {  // the first instant reports bits, but no numbers that stay
    const std::uint32_t symbol = sources_[i].symbol;
    if (symbol == tables::kNone || names.tables().symbols[symbol].type() != tables::DataType::boolean) look(i, now);
  }
}

void AlarmSources::add(const AlarmView& alarm, const View& view) {
  const tables::PlantTables& tables = names_.tables();
  const auto index = static_cast<std::uint32_t>(sources_.size());
  Source source{{}, alarm.symbol, alarm.value};
  std::uint32_t unit = tables::kNone;
  if (alarm.symbol != tables::kNone) {
    of_symbol_.resize(tables.symbols.size(), tables::kNone);
    of_symbol_[alarm.symbol] = index;
    source.alarm.name = names_.symbol(alarm.symbol);
    if (!view.symbols.empty()) source.alarm.text = view.symbols[alarm.symbol].comment;
    unit = tables.symbols[alarm.symbol].unit;
  } else {
    of_output_.resize(tables.values.outputs, tables::kNone);
    of_output_[alarm.value] = index;
    source.alarm.name = names_.output(alarm.value);
    unit = UnitNames(names_).of_value(source.alarm.name);
  }
  source.alarm.of = source.alarm.name;
  if (source.alarm.text.empty()) source.alarm.text = source.alarm.name;
  source.alarm.source = Alarm::Source::alarm;
  source.alarm.priority = alarm.priority;
  if (unit != tables::kNone) source.alarm.station = stations_[unit];
  sources_.push_back(std::move(source));
}

/// Another number of a message, such as 3 instead of 5, is another alarm.
void AlarmSources::look(std::uint32_t index, tables::Time time) {
  Source& source = sources_[index];
  const bool is_symbol = source.symbol != tables::kNone;
  const bool on = is_symbol ? history_.commands(source.symbol) : history_.output(source.output) != 0;
  const AlarmList::Entry* const known = list_.find(source.alarm.name);
  const bool was_on = known != nullptr && known->on;
  if (!on) return list_.go(source.alarm.name, time);
  const bool has_number = is_symbol && is_integer(names_.tables().symbols[source.symbol].type());
  const std::uint64_t number = has_number ? history_.value(source.symbol) : 0;
  if (was_on && number == source.number) return;
  source.number = number;
  if (!has_number) return list_.come(source.alarm, time, true);
  Alarm alarm = source.alarm;
  alarm.text += fmt::format(": {}", trace::json_value(names_.tables().symbols[source.symbol].type(), number));
  list_.come(alarm, time, true);
}

void AlarmSources::look_at_all(tables::Time now) {
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {
    const std::uint32_t symbol = sources_[i].symbol;
    look(i, symbol != tables::kNone ? std::min(now, history_.since(symbol)) : now);
  }
}

std::uint32_t AlarmSources::station_of(const trace::FoundThing& found) const {
  const std::vector<std::uint32_t> units = trace::units_of(found, names_.tables());
  if (units.empty() && trace::is_of_symbol(found.kind)) {
    if (const std::uint32_t unit = names_.tables().symbols[found.of.front()].unit; unit != tables::kNone)
      return stations_[unit];
  }
  if (units.empty()) return tables::kNone;
  const std::uint32_t station = stations_[units.front()];
  const bool one =
      std::all_of(units.begin(), units.end(), [&](std::uint32_t unit) { return stations_[unit] == station; });
  return one ? station : tables::kNone;
}

void AlarmSources::finding(const trace::FoundThing& found, const std::string& words) {
  const std::string of = subject_of(found, names_);
  if (found.kind == FindingKind::link_back) return list_.go(name_of(FindingKind::link_lost, of), found.time);
  Alarm alarm{name_of(found.kind, of), of, words};
  const bool violated = found.kind == FindingKind::requirement_violated;
  alarm.source = violated ? Alarm::Source::requirement : Alarm::Source::finding;
  alarm.priority = priority_of(found.kind);
  alarm.station = station_of(found);
  alarm.kind = found.kind;
  alarm.about = found.of;
  list_.come(alarm, found.time,
             found.kind == FindingKind::link_lost || lasting_.lasts(found.kind, found.of, found.time));
}

void AlarmSources::settle() {
  if (is_settled_) return;
  is_settled_ = true;
  std::vector<std::string> ended;
  for (const AlarmList::Entry* const entry : list_.on()) {
    const Alarm& alarm = entry->alarm;
    if (alarm.source == Alarm::Source::alarm || is_of_link(alarm)) continue;
    if (!lasting_.lasts(alarm.kind, alarm.about, time_)) ended.push_back(alarm.name);
  }
  for (const std::string& name : ended) list_.go(name, time_);
  list_.advance_to(time_);
}

void AlarmSources::settle(tables::Time now) {
  settle();
  list_.advance_to(now);
}

void AlarmSources::set_back(tables::Time until, tables::Time now) {
  list_.forget_after(until, is_of_link, [&](const Alarm& alarm) {
    return until >= 0 && alarm.source != Alarm::Source::alarm && lasting_.lasts(alarm.kind, alarm.about, now);
  });
  time_ = now;
  is_settled_ = false;
  settle();
  look_at_all(now);
}

}  // namespace symplant::panel
