// Lowers the malfunctions: a row each, and its units and symbols.
#include "elements/malfunction/lower.hpp"

#include "lower/random_time.hpp"

namespace symplant::lower {
namespace {

template <class T>
tables::Rows append(std::vector<T>& all, const std::vector<T>& some) {
  const tables::Rows rows{static_cast<std::uint32_t>(all.size()), static_cast<std::uint32_t>(some.size())};
  all.insert(all.end(), some.begin(), some.end());
  return rows;
}

}  // namespace

void lower_malfunctions(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  Malfunctions& rows = tables.malfunctions;
  for (std::uint32_t m = 0; m < plant.malfunctions.size(); ++m) {
    const model::Malfunction& malfunction = plant.malfunctions[m];
    const auto condition = [&](const std::optional<condition::Tree>& tree, std::uint8_t input) {
      return tree ? add_condition(*tree, tables::ReaderKind::malfunction, m, input) : tables::kNone;
    };
    const auto time = [&](const std::optional<description::Duration>& given) {
      return given ? lower_time(*given, tables) : 0;
    };
    tables::MalfunctionRow row;
    row.kind = malfunction.kind;
    row.of = malfunction.kind == tables::MalfunctionKind::force ? append(rows.forces, malfunction.forces)
                                                                : append(rows.units, malfunction.units);
    row.factor = malfunction.factor;
    row.subject = malfunction.subject;
    row.every = time(malfunction.every);
    row.shows = malfunction.shows;
    row.condition = condition(malfunction.condition, 0);
    row.chance = time(malfunction.chance);
    row.lasts = time(malfunction.lasts);
    row.after = malfunction.after;
    row.next = malfunction.next;
    row.unless = condition(malfunction.unless, 1);
    rows.rows.push_back(row);
    rows.names.append(malfunction.name).push_back('\0');
  }
}

}  // namespace symplant::lower
