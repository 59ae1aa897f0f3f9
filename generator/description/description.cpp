// Names of the keys of a device's entry.
#include "description/description.hpp"

#include "text/pattern.hpp"

namespace symplant::description {

std::string_view actuation_name(tables::Actuation actuation) {
  switch (actuation) {
    case tables::Actuation::latched:
      return "latched";
    case tables::Actuation::bistable:
      return "bistable";
    case tables::Actuation::held:
      return "held";
    case tables::Actuation::spring:
      return "spring";
  }
  return "";
}

std::string_view sequence_name(Sequence sequence) {
  switch (sequence) {
    case Sequence::free:
      return "free";
    case Sequence::neighbours:
      return "neighbours";
    case Sequence::cycle:
      return "cycle";
  }
  return "";
}

std::string_view device_key_name(DeviceKey key) {
  static constexpr std::array<std::string_view, kDeviceKeys> kNames{
      "states",   "initial", "rest",      "actuation", "only",    "transitions", "outputs",
      "disables", "type",    "behaviour", "inputs",    "overrun", "sequence"};
  return kNames[static_cast<std::size_t>(key)];
}

bool DeviceDescription::gives(DeviceKey key) const {
  if (given[static_cast<std::size_t>(key)]) return true;
  switch (key) {
    case DeviceKey::states:
      return !states.empty();
    case DeviceKey::initial:
      return initial.has_value();
    case DeviceKey::rest:
      return rest.has_value();
    case DeviceKey::actuation:
      return actuation.has_value();
    case DeviceKey::only:
      return only;
    case DeviceKey::transitions:
      return !transitions.empty();
    case DeviceKey::outputs:
      return !outputs.empty();
    case DeviceKey::disables:
      return !disables.empty();
    case DeviceKey::type:
      return !type.empty();
    case DeviceKey::behaviour:
      return !behaviour.empty();
    case DeviceKey::inputs:
      return !inputs.empty();
    case DeviceKey::overrun:
      return overrun.has_value();
    case DeviceKey::sequence:
      return sequence.has_value();
  }
  return false;
}

bool DeviceDescription::matches(std::string_view unit_path, std::string_view device_path) const {
  return text::matches_pattern(unit_path, path) ||
         (device_path.size() != unit_path.size() && text::matches_pattern(device_path, path));
}

void DeviceDescription::take(DeviceKey key, const DeviceDescription& other) {
  given[static_cast<std::size_t>(key)] = true;
  from[static_cast<std::size_t>(key)] = &other.entry_of(key);
  switch (key) {
    case DeviceKey::states:
      states = other.states;
      break;
    case DeviceKey::initial:
      initial = other.initial;
      break;
    case DeviceKey::rest:
      rest = other.rest;
      break;
    case DeviceKey::actuation:
      actuation = other.actuation;
      break;
    case DeviceKey::only:
      only = other.only;
      break;
    case DeviceKey::transitions:
      transitions = other.transitions;
      break;
    case DeviceKey::outputs:
      outputs = other.outputs;
      break;
    case DeviceKey::disables:
      disables = other.disables;
      break;
    case DeviceKey::type:
      type = other.type;
      break;
    case DeviceKey::behaviour:
      behaviour = other.behaviour;
      break;
    case DeviceKey::inputs:
      inputs = other.inputs;
      break;
    case DeviceKey::overrun:
      overrun = other.overrun;
      break;
    case DeviceKey::sequence:
      sequence = other.sequence;
      break;
  }
}

}  // namespace symplant::description
