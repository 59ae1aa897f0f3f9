// What a step does to a plant between two instants.
#include "symplant/scenario/act.hpp"

#include <algorithm>

namespace symplant::scenario {
namespace {

void set(const SymbolValue& value, plant::Plant& plant) noexcept {
  const tables::SymbolRow& row = plant.tables().symbols[value.symbol];
  if (row.direction() == tables::Direction::event) {
    plant.set_input(value.symbol, value.value);
  } else if (row.type() == tables::DataType::boolean) {
    plant.set_operation(row.index, value.value != 0);
  } else {
    plant.set_operation_value(row.index, value.value);
  }
}

void note_force(std::uint32_t symbol, bool forced, const plant::Plant& plant, trace::Recorder& recorder) noexcept {
  recorder.note(plant.now(), kForceNote, std::uint64_t{symbol} * 2 + (forced ? 1 : 0));
}

}  // namespace

bool needs_act(const Step& step, const tables::PlantTables& tables) noexcept {
  if (!(step.set_values.empty() && step.states.empty() && step.put.empty() && step.take.empty() && step.force.empty() &&
        step.release.empty() && step.stop.empty() && step.start.empty() && step.restart.empty())) {
    return true;
  }
  return std::any_of(step.set.begin(), step.set.end(), [&](const SymbolValue& value) {
    return tables.symbols[value.symbol].direction() == tables::Direction::event;
  });
}

std::size_t changes_by_hand(const Step& step) noexcept {
  return step.put.size() + step.take.size() + step.stop.size() + step.start.size();
}

void write_symbols(const Step& step, plant::Plant& plant, ProgramControl* programs) noexcept {
  if (programs != nullptr) {
    for (const std::uint32_t controller : step.restart) programs->restart(controller);
  }
  for (const SymbolValue& value : step.set) set(value, plant);
  for (const ValueSetting& setting : step.set_values) plant.set_value(setting.value, setting.number);
  for (const UnitState& unit : step.states) plant.set_state(unit.unit, unit.state);
}

void force_symbols(const Step& step, plant::Plant& plant, trace::Recorder& recorder) noexcept {
  for (const SymbolValue& value : step.force) {
    plant.force(value.symbol, value.value);
    note_force(value.symbol, true, plant, recorder);
  }
  for (const std::uint32_t symbol : step.release) release(symbol, plant, recorder);
}

void release(std::uint32_t symbol, plant::Plant& plant, trace::Recorder& recorder) noexcept {
  plant.release(symbol);
  note_force(symbol, false, plant, recorder);
}

}  // namespace symplant::scenario
