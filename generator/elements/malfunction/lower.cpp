// Lowers the malfunctions: a row each, its effects, and what they act on.
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

tables::Time lowered(const std::optional<description::Duration>& given, EngineTables& tables) {
  return given ? lower_time(*given, tables) : 0;
}

tables::EffectRow lowered(const model::Effect& effect, EngineTables& tables) {
  Malfunctions& rows = tables.malfunctions;
  tables::EffectRow row;
  row.kind = effect.kind;
  switch (effect.kind) {
    case tables::MalfunctionKind::force:
      row.of = append(rows.forces, effect.forces);
      break;
    case tables::MalfunctionKind::set:
      row.of = append(rows.sets, effect.sets);
      break;
    default:
      row.of = append(rows.units, effect.units);
  }
  row.tracks = append(rows.tracks, effect.tracks);
  row.factor = effect.factor;
  row.subject = effect.subject;
  row.every = lowered(effect.every, tables);
  row.shows = effect.shows;
  if (effect.kind != tables::MalfunctionKind::distort) return row;
  row.gain = effect.distort.gain;
  row.offset = effect.distort.offset;
  row.drift = effect.distort.drift;
  return row;
}

}  // namespace

void lower_malfunctions(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  Malfunctions& rows = tables.malfunctions;
  for (std::uint32_t m = 0; m < plant.malfunctions.size(); ++m) {
    const model::Malfunction& malfunction = plant.malfunctions[m];
    const auto condition = [&](const std::optional<condition::Tree>& tree, std::uint8_t input) {
      return tree ? add_condition(*tree, tables::ReaderKind::malfunction, m, input) : tables::kNone;
    };
    const auto time = [&](const std::optional<description::Duration>& given) { return lowered(given, tables); };
    tables::MalfunctionRow row;
    row.effects.first = static_cast<std::uint32_t>(rows.effects.size());
    row.effects.count = static_cast<std::uint32_t>(malfunction.effects.size());
    for (const model::Effect& effect : malfunction.effects) rows.effects.push_back(lowered(effect, tables));
    row.condition = condition(malfunction.condition, 0);
    row.during = malfunction.during;
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
