// Lowers the times of transitions, fixed and random.
#include "lower/time_table.hpp"

namespace symplant::lower {

tables::Time TimeTable::lowered(const description::Duration& duration, std::vector<tables::RandomTime>& random_times) {
  if (duration.kind == description::Duration::Kind::fixed) return duration.a;
  const tables::RandomTime row{duration.kind == description::Duration::Kind::uniform ? tables::RandomTime::Kind::uniform
                                                                                     : tables::RandomTime::Kind::normal,
                               duration.a, duration.b};
  const auto [found, added] =
      random_.try_emplace({row.kind, row.a, row.b}, -1 - static_cast<tables::Time>(random_times.size()));
  if (added) random_times.push_back(row);
  return found->second;
}

std::uint32_t TimeTable::times_of(std::uint32_t type, const model::Unit& unit, EngineTables& tables) {
  std::vector<std::int64_t>& key = key_;
  key.assign({type, unit.travel});
  for (const model::Transition& t : unit.transitions) {
    key.push_back(lowered(t.after, tables.random_times));
    key.push_back(lowered(t.takes, tables.random_times));
  }
  const auto first = static_cast<std::uint32_t>(tables.times.size());
  const auto [found, added] = by_times_.try_emplace(key, first);
  if (added) {
    const std::vector<std::int64_t>& times = found->first;
    tables.times.push_back({0, unit.travel});
    for (std::size_t i = 2; i < times.size(); i += 2) tables.times.push_back({times[i], times[i + 1]});
  }
  return found->second;
}

}  // namespace symplant::lower
