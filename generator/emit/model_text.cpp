// Texts for the comments of rows.
#include "emit/model_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "model/condition_text.hpp"

namespace symplant::emit {
namespace {

using condition::Tree;

constexpr std::size_t kLongest = 160;  ///< bytes of a condition that a comment shows

/// The reader of the condition `index` of a unit: the first transition that uses it, or an input of the behavior.
std::string unit_reader(std::uint32_t index, const lower::Type& type, const model::Unit& unit,
                        const model::PlantModel& plant) {
  for (const tables::Transition& t : type.transitions) {
    if (t.when == index || t.during == index) return transition_text(t, unit, plant);
  }
  const std::size_t input = index - unit.first_input;
  if (index >= unit.first_input && input < unit.input_names.size()) {
    return fmt::format("input {}", unit.input_names[input]);
  }
  return fmt::format("condition {}", index);
}

/// The track that has a row of one of its tables.
template <class RowsOf>
std::uint32_t track_with(std::uint32_t row, const lower::EngineTables& tables, RowsOf rows_of) {
  for (std::uint32_t t = 0; t < tables.material.tracks.size(); ++t) {
    const tables::Rows rows = rows_of(tables.material.tracks[t]);
    if (row >= rows.first && row < rows.first + rows.count) return t;
  }
  return 0;
}

/// The element of the material flow that reads a condition, and the condition.
std::string material_reader(const tables::ConditionRow& row, const lower::EngineTables& tables,
                            const model::PlantModel& plant) {
  using Kind = tables::ReaderKind;
  const model::Material& material = plant.material;
  const auto text = [&](std::string_view what, const std::string& name, const Tree& tree) {
    return fmt::format("{} {}: {}", what, name, short_condition_text(tree, plant));
  };
  if (row.reader_kind == Kind::transfer) {
    return text("transfer", material.transfers[row.reader].name, *material.transfers[row.reader].condition);
  }
  if (row.reader_kind == Kind::work) {
    return text("work", material.work[row.reader].name, material.work[row.reader].condition);
  }
  if (row.reader_kind == Kind::source) {
    return text("source", material.sources[row.reader].name, *material.sources[row.reader].condition);
  }
  const auto rows_of = [&](const tables::TrackRow& track) {
    return row.reader_kind == Kind::drive ? track.drives : row.reader_kind == Kind::stop ? track.stops : track.ends;
  };
  const std::uint32_t t = track_with(row.reader, tables, rows_of);
  const model::Track& track = material.tracks[t];
  const std::uint32_t n = row.reader - rows_of(tables.material.tracks[t]).first;
  if (row.reader_kind == Kind::stop) return text("stop of", track.name, track.stops[n].condition);
  if (row.reader_kind == Kind::end) return text("end of", track.name, *track.ends[n].condition);
  return row.reader_input == 0 ? text("forward of", track.name, *track.drives[n].forward)
                               : text("backward of", track.name, *track.drives[n].backward);
}

}  // namespace

std::string transition_text(const tables::Transition& transition, const model::Unit& unit,
                            const model::PlantModel& plant) {
  const std::string& from = unit.states[transition.from].name;
  const std::string& to = unit.states[transition.to].name;
  if (transition.on == tables::kSpringReturn) return fmt::format("spring return: {} to {}", from, to);
  if (transition.on == tables::kNoOperation) return fmt::format("d_int({}) = {}", from, to);
  const std::string_view task = plant.symbols[unit.operations[transition.on]].reading.task();
  return fmt::format("d_ext({}, O_{}) = {}", from, task, to);
}

std::string short_condition_text(const Tree& tree, const model::PlantModel& plant) {
  return model::condition_text(tree, plant, kLongest);
}

std::vector<std::string> random_time_readers(const lower::EngineTables& tables, const model::PlantModel& plant) {
  std::vector<std::string> readers(tables.random_times.size());
  if (readers.empty()) return readers;
  for (std::size_t u = 0; u < tables.units.size(); ++u) {
    const lower::Type& type = tables.types[tables.units[u].type];
    const auto& transitions = type.transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      const std::uint16_t dt = transitions[t].dt;
      const tables::TransitionTimes& times =
          (dt & tables::kOfDevice) == 0
              ? type.times[dt]
              : tables.times[tables.units[u].times + static_cast<std::uint32_t>(dt ^ tables::kOfDevice)];
      for (const tables::Time time : {times.after, times.takes}) {
        if (time >= 0) continue;
        std::string& reader = readers[static_cast<std::size_t>(-1 - time)];
        if (!reader.empty()) continue;
        reader = fmt::format("{}, {}", plant.units[u].path, transition_text(transitions[t], plant.units[u], plant));
      }
    }
  }
  const tables::MalfunctionTables all = tables.malfunctions.tables();
  for (std::size_t m = 0; m < tables.malfunctions.rows.size(); ++m) {
    const tables::MalfunctionRow& row = tables.malfunctions.rows[m];
    std::vector<tables::Time> times{row.chance, row.lasts};
    for (const tables::EffectRow& effect : all.effects_of(static_cast<std::uint32_t>(m))) times.push_back(effect.every);
    for (const tables::Time time : times) {
      if (time >= 0) continue;
      std::string& reader = readers[static_cast<std::size_t>(-1 - time)];
      if (reader.empty()) reader = fmt::format("malfunction {}", plant.malfunctions[m].name);
    }
  }
  for (std::size_t s = 0; s < tables.material.sources.size(); ++s) {
    const tables::Time every = tables.material.sources[s].every;
    if (every >= 0) continue;
    std::string& reader = readers[static_cast<std::size_t>(-1 - every)];
    if (reader.empty()) reader = fmt::format("source {}", plant.material.sources[s].name);
  }
  return readers;
}

std::vector<std::string> condition_readers(const lower::EngineTables& tables, const model::PlantModel& plant) {
  std::vector<std::string> readers;
  readers.reserve(tables.conditions.size());
  std::uint32_t index = 0;  // among the conditions of one reader, which are adjacent
  for (std::size_t i = 0; i < tables.conditions.size(); ++i) {
    const tables::ConditionRow& row = tables.conditions[i];
    if (i != 0 &&
        (tables.conditions[i - 1].reader != row.reader || tables.conditions[i - 1].reader_kind != row.reader_kind)) {
      index = 0;
    }
    switch (row.reader_kind) {
      case tables::ReaderKind::unit: {
        const model::Unit& unit = plant.units[row.reader];
        readers.push_back(fmt::format("{}, {}: {}", unit.path,
                                      unit_reader(index, tables.types[tables.units[row.reader].type], unit, plant),
                                      short_condition_text(unit.conditions[index], plant)));
        break;
      }
      case tables::ReaderKind::requirement: {
        const model::Requirement& requirement = plant.requirements[row.reader];
        const bool never = requirement.kind == tables::RequirementRow::Kind::never;
        readers.push_back(fmt::format(
            "{}, {}: {}", requirement.name,
            row.reader_input == 1 ? "expect"
            : never               ? "never"
                                  : "after",
            short_condition_text(row.reader_input == 1 ? requirement.expected : requirement.condition, plant)));
        break;
      }
      case tables::ReaderKind::follow: {
        const model::Follow& follow = plant.follows[row.reader];
        const bool off = row.reader_input == 1;
        readers.push_back(fmt::format("{} {}: {}", plant.symbols[follow.symbol].name(), off ? "off" : "follows",
                                      short_condition_text(off ? *follow.off : follow.condition, plant)));
        break;
      }
      case tables::ReaderKind::condition:
        readers.push_back(fmt::format("input {} of condition {}", row.reader_input, row.reader));
        break;
      case tables::ReaderKind::drive:
      case tables::ReaderKind::stop:
      case tables::ReaderKind::end:
      case tables::ReaderKind::transfer:
      case tables::ReaderKind::work:
      case tables::ReaderKind::source:
        readers.push_back(material_reader(row, tables, plant));
        break;
      case tables::ReaderKind::malfunction: {
        const model::Malfunction& malfunction = plant.malfunctions[row.reader];
        const bool unless = row.reader_input == 1;
        readers.push_back(
            fmt::format("{}, {}: {}", malfunction.name,
                        unless               ? "unless"
                        : malfunction.during ? "while"
                                             : "when",
                        short_condition_text(unless ? *malfunction.unless : *malfunction.condition, plant)));
        break;
      }
      case tables::ReaderKind::change: {
        const auto owner = std::find_if(plant.values.begin(), plant.values.end(), [&](const model::Value& value) {
          const tables::Rows& changes =
              tables.values.rows[static_cast<std::size_t>(&value - plant.values.data())].changes;
          return row.reader >= changes.first && row.reader < changes.first + changes.count;
        });
        const tables::Rows& changes =
            tables.values.rows[static_cast<std::size_t>(owner - plant.values.begin())].changes;
        readers.push_back(fmt::format("{}, jump: {}", owner->name,
                                      short_condition_text(owner->changes[row.reader - changes.first].when, plant)));
        break;
      }
      case tables::ReaderKind::formula_input:
        readers.push_back(fmt::format("input {} of the formulas", row.reader));
        break;
    }
    ++index;
  }
  return readers;
}

}  // namespace symplant::emit
