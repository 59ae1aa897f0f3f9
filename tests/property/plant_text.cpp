// From plain values to the plant's model, by the tool's own layers.
#include "property/plant_text.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "model/derive.hpp"
#include "name/named_table.hpp"
#include "naming/load.hpp"
#include "property/behaviours.hpp"
#include "property/cell_plant.hpp"
#include "read/symbol_table.hpp"

namespace symplant::property {
namespace {

std::shared_ptr<const read::SymbolTable> table_of(const PlantText& text, std::size_t begin, std::size_t end) {
  auto table = std::make_shared<read::SymbolTable>();
  const std::string name = text.name + (begin == 0 ? ".csv" : "_2.csv");
  table->source = std::make_shared<const text::SourceFile>(name, std::string());
  const auto cell = [&](const std::string& content) -> std::string_view { return table->arena.emplace_back(content); };
  std::uint32_t line = 1;
  for (std::size_t i = begin; i < end; ++i) {
    const Row& row = text.rows[i];
    read::ListRow made{};
    made.klass = "VAR_GLOBAL";
    made.name = cell(row.name);
    made.iec_address = cell(row.address);
    made.type = cell(row.type);
    made.initial = cell(row.initial);
    made.line = ++line;
    table->rows.push_back(made);
  }
  return table;
}

bool serves_behaviour(const model::Unit& unit) {
  return unit.operations.size() >= kLeastOperations && unit.events.size() >= kLeastEvents &&
         unit.values.size() >= kLeastValues && unit.states.size() >= kLeastStates &&
         unit.described->inputs.size() >= kLeastInputs && is_behaviour(unit.described->behaviour);
}

}  // namespace

model::Derived build(const PlantText& text) {
  std::vector<name::NamingFault> faults;
  const auto reader = std::make_shared<name::SymbolReader>(
      text.naming.empty() ? naming::strict_naming() : name::CompiledNaming::compile(naming_of(text.naming), faults));
  std::vector<model::ListInput> lists;
  const auto add = [&](std::size_t begin, std::size_t end, const std::string& controller) {
    const auto table = table_of(text, begin, end);
    lists.push_back({table, name::read_names(*table, *reader), controller});
  };
  const std::size_t first_end = text.two_lists() ? text.second_list : text.rows.size();
  add(0, first_end, "");
  if (text.two_lists()) add(first_end, text.rows.size(), text.second_controller);
  const auto description = std::make_shared<const description::Description>(text.description);
  return model::describe(model::derive(lists, text.name, reader, description.get()), description);
}

// What the reading of plant.json ensures, and what the model is not asked about.
bool drives_are_complete(const model::PlantModel& plant) {
  for (const description::GivenTrack& track : plant.description->material.tracks) {
    if (track.drives.empty()) return false;
    for (const description::GivenDrive& drive : track.drives) {
      if (drive.until.has_value() == (&drive == &track.drives.back())) return false;
    }
  }
  return true;
}

bool runnable(const model::Derived& derived) {
  const model::PlantModel& plant = derived.plant;
  if (!drives_are_complete(plant)) return false;
  if (!derived.evidence.faults.empty() || !derived.evidence.driven_twice.empty()) return false;
  return std::all_of(plant.units.begin(), plant.units.end(), [](const model::Unit& unit) {
    return unit.described == nullptr || unit.described->behaviour.empty() || serves_behaviour(unit);
  });
}

std::string list_text(const PlantText& text, std::size_t begin, std::size_t end) {
  std::string list = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  for (std::size_t i = begin; i < end; ++i) {
    const Row& row = text.rows[i];
    list += "VAR_GLOBAL," + row.name + ",," + row.address + "," + row.type + "," + row.initial + "\n";
  }
  return list;
}

std::string list_text(const PlantText& text) { return list_text(text, 0, text.rows.size()); }

}  // namespace symplant::property
