// What rules share.
#include "check/rule.hpp"

#include <algorithm>
#include <utility>

#include "check/spelling/device_classes.hpp"
#include "text/shape.hpp"
#include "text/utf8.hpp"

namespace symplant::check {

using Kind = diag::Subject::Kind;

namespace {

/// Of the text by which people know the symbol: its name, or its comment where the list has addresses for names.
std::string shape_of(const read::ListRow& row) {
  return text::shape_of(row.is_named_by_address() && !row.comment.empty() ? row.comment : row.name);
}

}  // namespace

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
  const diag::Location fallback = location_of(plant, first_symbol_of(plant, unit));
  return unit.described->by_naming ? fallback : location_of(fallback, pointer);
}

description::Pointer transition_pointer(const model::Unit& unit, const model::Transition& transition,
                                        std::string_view key) {
  const description::Pointer here =
      description::key_pointer(*unit.described, description::DeviceKey::transitions) / std::size_t{transition.given};
  return key.empty() ? here : here / key;
}

description::Pointer entry_pointer(const model::Unit& unit) {
  for (const description::DeviceDescription* entry : unit.described->from) {
    if (entry != nullptr && !entry->by_naming) return description::device_pointer(*entry);
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

diag::Subjects about(const model::Symbol& symbol) {
  diag::Subjects subjects;
  subjects.about.reserve(2);
  subjects.about.push_back(symbol_named(symbol.name()));
  if (symbol.reading.fault == name::NameFault::none) subjects.about.push_back(device(symbol.reading.device_path()));
  subjects.shape = shape_of(*symbol.row);
  return subjects;
}

diag::Subjects about(const model::Symbol& symbol, const model::Symbol& other) {
  diag::Subjects subjects = about(symbol);
  subjects.about.insert(subjects.about.begin() + 1, symbol_named(other.name()));
  return subjects;
}

diag::Subjects about(const model::Unit& unit) { return {{device(unit.path)}, {}, {}}; }

diag::Subjects about(const read::ListRow& row) { return {{symbol_named(row.name)}, {}, {}, shape_of(row)}; }

std::string type_shape(const model::Unit& unit) {
  std::string type = class_name(unit.device);
  return type.find('#') == std::string::npos ? text::shape_of(unit.path) : type;
}

diag::Rename rename_of(const model::Symbol& symbol, std::string to, bool safe) {
  return {std::string(symbol.name()), std::move(to), std::string(symbol.written_address()), safe};
}

diag::Subject device(std::string_view path) { return {Kind::device, std::string(path)}; }

diag::Subject model_of(std::string_view path) { return {Kind::model, std::string(path)}; }

diag::Subject sequence_of(std::string_view path) { return {Kind::sequence, std::string(path)}; }

diag::Subject symbol_named(std::string_view name) { return {Kind::symbol, std::string(name)}; }

diag::Subject address_of(std::string_view symbol) { return {Kind::address, std::string(symbol)}; }

diag::Subject missing(std::string name) { return {Kind::missing, std::move(name)}; }

diag::Subject missing(const model::PlantModel& plant, std::string_view path, tables::Direction direction,
                      std::string_view task) {
  const bool operation = direction == tables::Direction::operation;
  const auto& words = plant.rule->directions;
  const auto word = std::find_if(words.begin(), words.end(), [&](const name::DirectionWord& known) {
    return (known.direction == name::Direction::operation) == operation;
  });
  std::string separator;
  text::append_utf8(separator, plant.rule->separator);
  return missing(std::string(path) + separator + word->word + separator + std::string(task));
}

diag::Subject side_of(std::string_view path, tables::Direction direction) {
  return {direction == tables::Direction::operation ? Kind::operations : Kind::events, std::string(path)};
}

void explain_missing(diag::Subjects& subjects, std::string name, std::string_view path, tables::Direction direction) {
  subjects.explains.push_back(missing(std::move(name)));
  subjects.explains.push_back(side_of(path, direction));
  subjects.explains.push_back(model_of(path));
}

std::vector<diag::Subject> missing_sides(const model::PlantModel& plant, const model::Unit& unit, std::size_t more) {
  const auto one_side = [](const model::State& state) {
    return (state.operation == model::kNone) != (state.event == model::kNone);
  };
  std::vector<diag::Subject> subjects;
  subjects.reserve(static_cast<std::size_t>(std::count_if(unit.states.begin(), unit.states.end(), one_side)) + more);
  for (const model::State& state : unit.states) {
    if (!one_side(state)) continue;
    const auto direction = state.operation == model::kNone ? tables::Direction::operation : tables::Direction::event;
    subjects.push_back(missing(plant, unit.path, direction, state.name));
  }
  return subjects;
}

diag::Subjects about_model(const model::PlantModel& plant, const model::Unit& unit) {
  diag::Subjects subjects = about(unit);
  subjects.shape = text::shape_of(unit.path);
  subjects.follows = missing_sides(plant, unit, 2);
  subjects.follows.push_back(device(unit.path));
  subjects.follows.push_back(model_of(unit.path));
  return subjects;
}

diag::Subjects about_sides(const model::PlantModel& plant, const model::Unit& unit, diag::Subjects subjects) {
  subjects.explains = missing_sides(plant, unit, 0);
  subjects.follows.reserve(subjects.follows.size() + subjects.explains.size() + 2);
  subjects.follows.insert(subjects.follows.end(), subjects.explains.begin(), subjects.explains.end());
  const bool no_events = unit.events.empty();
  subjects.follows.push_back(side_of(unit.path, no_events ? tables::Direction::event : tables::Direction::operation));
  subjects.follows.push_back(device(unit.path));
  return subjects;
}

const model::Symbol* symbol_of(const model::PlantModel& plant, const read::ListRow& row) {
  const std::uint32_t list = plant.list_of(row);
  const auto symbol = std::lower_bound(plant.symbols.begin(), plant.symbols.end(), &row,
                                       [&](const model::Symbol& a, const read::ListRow* wanted) {
                                         return a.list != list ? a.list < list : a.row < wanted;
                                       });
  return symbol != plant.symbols.end() && symbol->row == &row ? &*symbol : nullptr;
}

std::string_view direction_text(tables::Direction direction) {
  return direction == tables::Direction::operation ? "operation" : "event";
}

}  // namespace symplant::check
