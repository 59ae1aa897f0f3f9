// A file with a list of malfunctions.
#include "elements/malfunction/file.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "description/json_entry.hpp"
#include "description/plant_schema.hpp"
#include "elements/malfunction/entry.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"

namespace symplant::description {
namespace {

constexpr std::string_view kKey = "/malfunctions";

}  // namespace

MalfunctionsReading read_malfunctions(std::string_view text) {
  MalfunctionsReading reading;
  json::Document document = json::parse(text);
  reading.syntax = std::move(document.faults);
  if (document.root == nullptr) return reading;
  if (!document.root->is_array()) {
    reading.faults.push_back(
        {"", "this is no list of malfunctions, as `malfunctions` of a plant.json", 0, FaultKind::shape});
    return reading;
  }
  // As part of a plant description, so that there is one schema.
  const nlohmann::json plant{{"symplant", 1}, {"symbols", {"-"}}, {"malfunctions", std::move(*document.root)}};
  for (json::Fault& fault : json::Schema(plant_schema()).check(plant)) {
    reading.faults.push_back(
        {std::move(fault.pointer), std::move(fault.message), fault.column, FaultKind::shape, fault.at_key});
  }
  ShapeFaults faults(reading.faults);
  reading.malfunctions = malfunction_entries(plant["malfunctions"], faults);
  for (DescriptionFault& fault : reading.faults) fault.pointer = pointer_in_file(fault.pointer, 0);
  return reading;
}

std::string pointer_in_file(std::string_view pointer, std::size_t own) {
  if (!pointer.starts_with(kKey) || pointer.size() == kKey.size()) return {};
  std::string_view rest = pointer.substr(kKey.size() + 1);
  std::size_t index = 0;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), index);
  if (read.ec != std::errc() || index < own) return {};
  return "/" + std::to_string(index - own) + std::string(read.ptr, rest.data() + rest.size());
}

}  // namespace symplant::description
