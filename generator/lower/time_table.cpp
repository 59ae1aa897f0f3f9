// Lowers the times of transitions, fixed and random.
#include "lower/time_table.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace symplant::lower {
namespace {

using tables::TransitionTimes;
using Times = std::vector<TransitionTimes>;
using Row = std::vector<tables::Time>;  ///< a device's own times, two each: after, takes

bool equal(const TransitionTimes& a, const TransitionTimes& b) { return a.after == b.after && a.takes == b.takes; }

/// Whether a move without a transition can happen: the return of a spring, or a wish of a custom behavior.
bool moves_without_transition(const model::Unit& unit) {
  return unit.actuation == tables::Actuation::spring || unit.has_behaviour();
}

class TimeTable {
 public:
  TimeTable(const model::PlantModel& plant, EngineTables& tables) : plant_(plant), tables_(tables) {}

  void run() {
    std::vector<std::vector<std::uint32_t>> units(tables_.types.size());
    for (std::uint32_t u = 0; u < tables_.units.size(); ++u) units[tables_.units[u].type].push_back(u);
    for (std::size_t t = 0; t < units.size(); ++t) lower_type(tables_.types[t], units[t]);
  }

 private:
  tables::Time lowered(const description::Duration& duration) {
    using Kind = description::Duration::Kind;
    if (duration.kind == Kind::fixed) return duration.a;
    if (duration.kind == Kind::seconds) return computed(duration);
    const tables::RandomTime row{
        duration.kind == Kind::uniform ? tables::RandomTime::Kind::uniform : tables::RandomTime::Kind::normal,
        duration.a, duration.b};
    const auto [found, added] =
        random_.try_emplace({row.kind, row.a, row.b}, -1 - static_cast<tables::Time>(tables_.random_times.size()));
    if (added) tables_.random_times.push_back(row);
    return found->second;
  }

  /// A reference to a row that has the index of the formula in the model until the values are lowered.
  tables::Time computed(const description::Duration& duration) {
    const auto [found, added] =
        computed_.try_emplace(duration.a, -1 - static_cast<tables::Time>(tables_.random_times.size()));
    if (!added) return found->second;
    tables_.random_times.push_back({tables::RandomTime::Kind::seconds, duration.a, 0});
    return found->second;
  }

  /// The times of a unit's transitions, then that of a move without one, if there can be one.
  void put_times(const model::Unit& unit, Times& times) {
    times.clear();
    for (const model::Transition& t : unit.transitions) {
      const tables::Time after = lowered(t.after);
      times.push_back({after, lowered(t.takes)});
    }
    if (moves_without_transition(unit)) times.push_back({0, unit.travel});
  }

  void lower_type(Type& type, const std::vector<std::uint32_t>& units) {
    put_times(plant_.units[type.example], example_);
    std::vector<std::uint32_t> group(example_.size());  // times that are equal in every device
    std::vector<bool> differs(example_.size());
    split(example_, group);
    for (const std::uint32_t u : units) {
      put_times(plant_.units[u], times_);
      bool any = false;
      for (std::size_t i = 0; i < times_.size(); ++i) {
        if (equal(times_[i], example_[i])) continue;
        differs[i] = any = true;
      }
      if (any) split(times_, group);
    }
    const std::vector<std::uint32_t> own = number(type, group, differs);
    if (!own.empty()) add_rows(units, own);
  }

  /// Splits the groups so that the members of each have equal times. A group is named by its first member.
  void split(const Times& times, std::vector<std::uint32_t>& group) const {
    std::map<std::tuple<std::uint32_t, tables::Time, tables::Time>, std::uint32_t> first;
    for (std::uint32_t i = 0; i < times.size(); ++i) {
      group[i] = first.try_emplace({group[i], times[i].after, times[i].takes}, i).first->second;
    }
  }

  /// Numbers the times in the order of their first transition. Returns the groups that are rows of the devices.
  std::vector<std::uint32_t> number(Type& type, const std::vector<std::uint32_t>& group,
                                    const std::vector<bool>& differs) const {
    std::vector<std::uint32_t> own;
    std::vector<std::uint16_t> dt(group.size());
    for (std::uint32_t i = 0; i < group.size(); ++i) {
      if (group[i] != i) {
        dt[i] = dt[group[i]];
      } else if (differs[i]) {
        dt[i] = static_cast<std::uint16_t>(tables::kOfDevice | own.size());
        own.push_back(i);
      } else {
        dt[i] = static_cast<std::uint16_t>(type.times.size());
        type.times.push_back(example_[i]);
      }
      if (i < type.transitions.size()) type.transitions[i].dt = dt[i];
    }
    if (group.size() > type.transitions.size()) type.travel = dt.back();
    return own;
  }

  void add_rows(const std::vector<std::uint32_t>& units, const std::vector<std::uint32_t>& own) {
    std::map<Row, std::uint32_t> by_times;
    Row row;
    for (const std::uint32_t u : units) {
      put_times(plant_.units[u], times_);
      row.clear();
      for (const std::uint32_t i : own) row.insert(row.end(), {times_[i].after, times_[i].takes});
      const auto [found, added] = by_times.try_emplace(row, static_cast<std::uint32_t>(tables_.times.size()));
      tables_.units[u].times = found->second;
      if (!added) continue;
      for (const std::uint32_t i : own) tables_.times.push_back(times_[i]);
    }
  }

  const model::PlantModel& plant_;
  EngineTables& tables_;
  Times example_;
  Times times_;  ///< of the current unit
  std::map<std::tuple<tables::RandomTime::Kind, tables::Time, tables::Time>, tables::Time> random_;
  std::map<tables::Time, tables::Time> computed_;  ///< by index of the formula
};

}  // namespace

void lower_times(const model::PlantModel& plant, EngineTables& tables) { TimeTable(plant, tables).run(); }

}  // namespace symplant::lower
