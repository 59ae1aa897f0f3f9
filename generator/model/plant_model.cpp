// Texts and lookups of the plant model.
#include "model/plant_model.hpp"

#include <algorithm>
#include <functional>

namespace symplant::model {

std::string_view internal_reason_text(InternalReason reason) {
  switch (reason) {
    case InternalReason::constant:
      return "constants";
    case InternalReason::memory:
      return "memory addresses";
    case InternalReason::type:
      return "types that are no I/O";
    case InternalReason::no_direction:
      return "no address and no direction in the name";
  }
  return "";
}

bool Unit::reaches(std::uint32_t state) const {
  if (has_behaviour() || (actuation == tables::Actuation::spring && state == rest)) return true;
  return std::any_of(transitions.begin(), transitions.end(), [&](const Transition& t) { return t.to == state; });
}

bool Unit::moves_event(std::uint32_t event) const {
  if (has_behaviour()) return true;
  if (!moves()) return false;
  const auto switches = [&](std::uint32_t state) {
    if (states[state].event == event) return true;
    if (outputs.empty()) return false;
    const auto is_event = [&](const std::pair<std::uint32_t, bool>& output) { return output.first == event; };
    const auto& [enter, leave] = outputs[state];
    return std::any_of(enter.begin(), enter.end(), is_event) || std::any_of(leave.begin(), leave.end(), is_event);
  };
  for (std::uint32_t state = 0; state < states.size(); ++state) {
    if (switches(state) && (state == initial || reaches(state))) return true;
  }
  return false;
}

std::string PlantList::name() const {
  const std::string& path = table->source->path();
  return path.substr(path.find_last_of("/\\") + 1);
}

std::string_view PlantModel::rule_text() const {
  if (levels() != nullptr) return levels()->pattern;
  const std::string& named = naming().name;
  return named.empty() ? std::string_view("naming.json") : std::string_view(named);
}

std::uint32_t PlantModel::list_of(const read::ListRow& row) const {
  const std::less<> before;  // a total order, even of pointers into different lists
  for (std::uint32_t list = 0; list < lists.size(); ++list) {
    const std::vector<read::ListRow>& rows = lists[list].table->rows;
    if (!before(&row, rows.data()) && before(&row, rows.data() + rows.size())) return list;
  }
  return 0;
}

std::string PlantModel::list_names() const {
  std::string names;
  for (const PlantList& list : lists) names.append(names.empty() ? "" : ", ").append(list.name());
  return names;
}

std::vector<const text::SourceFile*> PlantModel::sources() const {
  std::vector<const text::SourceFile*> sources;
  for (const PlantList& list : lists) sources.push_back(list.table->source.get());
  return sources;
}

std::vector<std::string> PlantModel::input_files() const {
  std::vector<std::string> files;
  if (description_source != nullptr) files = description_source->paths();
  for (const text::SourceFile* list : sources()) files.push_back(list->path());
  files.insert(files.end(), naming_files.begin(), naming_files.end());
  return files;
}

std::string output_name(const PlantModel& plant, std::uint32_t output) {
  const auto next = std::upper_bound(plant.values.begin(), plant.values.end(), output,
                                     [](std::uint32_t a, const Value& b) { return a < b.row.output; });
  const Value& value = *std::prev(next);
  if (value.row.outputs == 1) return value.name;
  return value.name + "[" + std::to_string(output - value.row.output + 1) + "]";
}

}  // namespace symplant::model
