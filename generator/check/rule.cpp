// What rules share.
#include "check/rule.hpp"

#include <algorithm>

namespace symplant::check {

diag::Location location_of(const model::PlantModel& plant, const read::ListRow& row, std::string_view cell) {
  const auto& source = plant.lists[plant.list_of(row)].table->source;
  return {source, cell.empty() ? row.whole : source->span_of(cell, row.whole)};
}

diag::Location location_of(const model::PlantModel& plant, const model::Symbol& symbol) {
  return location_of(plant, *symbol.row, symbol.name());
}

diag::Location location_of(diag::Location fallback, const description::Pointer& pointer) {
  fallback.pointer = pointer.text();
  return fallback;
}

diag::Location described_location(const model::PlantModel& plant, const model::Unit& unit,
                                  const description::Pointer& pointer) {
  return location_of(location_of(plant, first_symbol_of(plant, unit)), pointer);
}

description::Pointer transition_pointer(const model::Unit& unit, const model::Transition& transition,
                                        std::string_view key) {
  const description::Pointer here =
      description::key_pointer(*unit.described, description::DeviceKey::transitions) / std::size_t{transition.given};
  return key.empty() ? here : here / key;
}

description::Pointer entry_pointer(const model::Unit& unit) {
  for (const description::DeviceDescription* entry : unit.described->from) {
    if (entry != nullptr) return description::device_pointer(*entry);
  }
  return description::device_pointer(*unit.described);
}

description::Pointer transitions_pointer(const model::Unit& unit) {
  return unit.described->only ? description::key_pointer(*unit.described, description::DeviceKey::only)
                              : entry_pointer(unit);
}

bool has_description(const model::PlantModel& plant) {
  return plant.description_source != nullptr || !plant.description->devices.empty() ||
         !plant.description->requirements.empty();
}

bool is_described(const Subject& subject) {
  const description::Description& description = *subject.plant.description;
  return subject.evidence.faults.empty() && (!description.devices.empty() || !description.requirements.empty());
}

const model::UnitEvidence& evidence_of(const Subject& subject, const model::Unit& unit) {
  return subject.evidence.units[static_cast<std::size_t>(&unit - subject.plant.units.data())];
}

const model::Symbol& operation_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location) {
  return plant.symbols[unit.operations[location]];
}

const model::Symbol& event_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location) {
  return plant.symbols[unit.events[location]];
}

const model::Symbol& first_symbol_of(const model::PlantModel& plant, const model::Unit& unit) {
  std::uint32_t first = model::kNone;
  for (const auto* side : {&unit.operations, &unit.events}) {
    if (!side->empty()) first = std::min(first, side->front());
  }
  return plant.symbols[first];
}

std::vector<std::string> about(const model::Symbol& symbol) {
  std::vector<std::string> names{std::string(symbol.name())};
  if (symbol.reading.fault == name::NameFault::none) names.emplace_back(symbol.reading.device_path);
  return names;
}

std::vector<std::string> about(const model::Symbol& symbol, const model::Symbol& other) {
  std::vector<std::string> names = about(symbol);
  names.emplace(names.begin() + 1, other.name());
  return names;
}

std::vector<std::string> about(const model::Unit& unit) { return {std::string(unit.path)}; }

std::vector<std::string> about(const read::ListRow& row) { return {std::string(row.name)}; }

std::string_view direction_text(tables::Direction direction) {
  return direction == tables::Direction::operation ? "operation" : "event";
}

}  // namespace symplant::check
