// Reads one entry of `devices` in plant.json.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "description/json_entry.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

class DeviceReader {
 public:
  DeviceReader(const std::string& path, const Json& entry, ShapeFaults& faults)
      : entry_(entry), faults_(faults), here_(Pointer("/devices") / path) {
    device_.path = path;
  }

  DeviceDescription read() {
    for (std::size_t k = 0; k < kDeviceKeys; ++k) {
      device_.given[k] = member(entry_, device_key_name(static_cast<DeviceKey>(k))) != nullptr;
    }
    if (device_.is_pattern()) keep_texts();
    device_.states = texts(member(entry_, "states"));
    for (std::size_t i = 0; i < device_.states.size(); ++i) {
      check_text(device_.states[i], here_ / "states" / i, faults_);
    }
    if (const std::string* initial = text_member(entry_, "initial")) device_.initial = *initial;
    if (const std::string* rest = text_member(entry_, "rest")) device_.rest = *rest;
    device_.actuation = actuation_member(entry_);
    device_.only = flag_member(entry_, "only");
    read_transitions();
    read_outputs();
    read_disables();
    device_.type = class_name("type");
    device_.behaviour = class_name("behaviour");
    read_inputs();
    device_.operations = own_symbols("operations");
    device_.events = own_symbols("events");
    device_.overrun = overrun_member(entry_, here_, faults_);
    device_.sequence = sequence_member(entry_);
    if (!device_.is_pattern()) refuse_braces();
    return std::move(device_);
  }

 private:
  void keep_texts() {
    device_.texts.resize(kDeviceKeys);
    for (std::size_t k = 0; k < kDeviceKeys; ++k) {
      const Json* value = member(entry_, device_key_name(static_cast<DeviceKey>(k)));
      if (value != nullptr) device_.texts[k] = value->dump();
    }
  }

  static std::vector<std::string> texts(const Json* array) {
    std::vector<std::string> all;
    if (array == nullptr || !array->is_array()) return all;
    for (const Json& one : *array) all.push_back(one.is_string() ? one.get<std::string>() : std::string());
    return all;
  }

  void read_transitions() {
    const Json* array = member(entry_, "transitions");
    if (array == nullptr || !array->is_array()) return;
    const Pointer here = here_ / "transitions";
    device_.transitions.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) device_.transitions.push_back(transition((*array)[i], here / i));
  }

  GivenTransition transition(const Json& value, const Pointer& here) {
    GivenTransition given;
    given.from = text_or_empty(value, "from");
    given.to = text_or_empty(value, "to");
    given.on = text_or_empty(value, "on");
    given.when = text_or_empty(value, "when");
    given.during = text_or_empty(value, "while");
    given.automatic = flag_member(value, "automatic");
    given.once = flag_member(value, "once");
    for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
      const Json* written = member(value, number.key);
      if (written != nullptr && written->is_number_unsigned()) {
        given.numbers.*number.member = written->get<std::uint32_t>();
      }
    }
    given.after = computed_duration_member(value, "after", here, faults_);
    given.takes = computed_duration_member(value, "takes", here, faults_);
    return given;
  }

  void read_outputs() {
    const Json* states = member(entry_, "outputs");
    if (states == nullptr || !states->is_object()) return;
    const auto switched = [](const Json* events) {
      std::vector<std::pair<std::string, bool>> all;
      if (events == nullptr || !events->is_object()) return all;
      for (const auto& [task, on] : events->items()) {
        if (on.is_boolean()) all.emplace_back(task, on.get<bool>());
      }
      return all;
    };
    for (const auto& [state, lists] : states->items()) {
      device_.outputs.push_back({state, switched(member(lists, "enter")), switched(member(lists, "leave"))});
    }
  }

  void read_disables() {
    const Json* states = member(entry_, "disables");
    if (states == nullptr || !states->is_object()) return;
    for (const auto& [state, devices] : states->items()) device_.disables.push_back({state, texts(&devices)});
  }

  void read_inputs() {
    const Json* inputs = member(entry_, "inputs");
    if (inputs == nullptr || !inputs->is_object()) return;
    for (const auto& [name, condition] : inputs->items()) {
      if (condition.is_string()) device_.inputs.emplace_back(name, condition.get<std::string>());
    }
  }

  std::vector<std::pair<std::string, std::string>> own_symbols(std::string_view key) {
    std::vector<std::pair<std::string, std::string>> symbols;
    const Json* tasks = member(entry_, key);
    if (tasks == nullptr || !tasks->is_object()) return symbols;
    if (device_.is_pattern()) {
      faults_.add(here_ / key,
                  ticked(key) + " names the symbols of one device, and " + ticked(device_.path) +
                      " is a pattern; write an entry for each device",
                  FaultKind::contradiction);
      return symbols;
    }
    for (const auto& [task, symbol] : tasks->items()) {
      check_text(task, here_ / key / std::string_view(task), faults_);
      if (symbol.is_string()) symbols.emplace_back(task, symbol.get<std::string>());
    }
    return symbols;
  }

  /// Names in braces refer to what a pattern matches.
  void refuse_braces() {
    const auto refuse = [this](const std::string& text, const Pointer& here) {
      const std::size_t open = text.find('{');
      if (open == text.npos || text.find('\'') < open) return;  // in quotes it may be part of a name
      faults_.add(here,
                  ticked(text.substr(open, text.find('}', open) + 1 - open)) +
                      " is replaced by a name only under a pattern, and " + ticked(device_.path) +
                      " is one device; write the name",
                  FaultKind::contradiction);
    };
    for (std::size_t i = 0; i < device_.transitions.size(); ++i) {
      refuse(device_.transitions[i].when, here_ / "transitions" / i / "when");
      refuse(device_.transitions[i].during, here_ / "transitions" / i / "while");
    }
    for (const auto& [name, condition] : device_.inputs) refuse(condition, here_ / "inputs" / name);
    for (const GivenDisables& entry : device_.disables) {
      for (std::size_t i = 0; i < entry.devices.size(); ++i) {
        refuse(entry.devices[i], here_ / "disables" / entry.state / i);
      }
    }
  }

  std::string class_name(std::string_view key) {
    const std::string* name = text_member(entry_, key);
    if (name == nullptr || name->empty()) return {};
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
    const bool sound = is_letter(name->front()) && std::all_of(name->begin(), name->end(), [&](char c) {
                         return is_letter(c) || (c >= '0' && c <= '9');
                       });
    if (sound) return *name;
    faults_.add(here_ / key, ticked(*name) + " is not a valid C++ class name; use letters, digits and `_`");
    return {};
  }

  const Json& entry_;
  ShapeFaults& faults_;
  const Pointer here_;
  DeviceDescription device_;
};

}  // namespace

DeviceDescription device_entry(const std::string& path, const Json& entry, ShapeFaults& faults) {
  return DeviceReader(path, entry, faults).read();
}

}  // namespace symplant::description
