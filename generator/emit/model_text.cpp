// Texts for the comments of rows.
#include "emit/model_text.hpp"

#include <fmt/format.h>

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

}  // namespace

std::string transition_text(const tables::Transition& transition, const model::Unit& unit,
                            const model::PlantModel& plant) {
  const std::string& from = unit.states[transition.from].name;
  const std::string& to = unit.states[transition.to].name;
  if (transition.on == tables::kSpringReturn) return fmt::format("spring return: {} to {}", from, to);
  if (transition.on == tables::kNoOperation) return fmt::format("d_int({}) = {}", from, to);
  const std::string_view task = plant.symbols[unit.operations[transition.on]].reading.task;
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
        readers.push_back(fmt::format("{} follows: {}", plant.symbols[follow.symbol].name(),
                                      short_condition_text(follow.condition, plant)));
        break;
      }
      case tables::ReaderKind::condition:
        readers.push_back(fmt::format("input {} of condition {}", row.reader_input, row.reader));
        break;
    }
    ++index;
  }
  return readers;
}

}  // namespace symplant::emit
