// What the reference derives of values: entries with `for` made once a device, their numbers, formulas and conditions.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/reference/patterns.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::ValueKind;

/// An entry as it is for one device.
struct MadeValue {
  description::GivenValue given;
  bool of_pattern = false;  ///< it is left out if it names what the device lacks
};

description::GivenValue value_for(const description::GivenValue& given, const Rules& rules, std::uint32_t unit) {
  const model::PlantModel& model = *rules.model;
  const model::Unit& its = model.units[unit];
  const model::SymbolReading& reading = model.symbols[its.first_symbol()].reading;
  const std::string self(its.device_path());
  const std::vector<std::string> levels = {std::string(reading.line()), std::string(reading.process()),
                                           std::string(its.device), self};
  const std::vector<std::string> matched = shares(self, given.for_each);
  const auto replace = [&](std::string& text) { text = replace_braces(text, levels, matched); };
  description::GivenValue made = given;
  for (std::string* text : {&made.name, &made.unit, &made.formula, &made.up, &made.down, &made.of, &made.to}) {
    replace(*text);
  }
  for (std::string& text : made.u) replace(text);
  for (auto& [state, number] : made.at) replace(state);
  for (description::GivenChange& change : made.changes) {
    replace(change.when);
    replace(change.to);
  }
  return made;
}

/// Every value in the order of the file; those of one pattern in the order of the devices.
std::vector<MadeValue> made_values(const Rules& rules) {
  std::vector<MadeValue> made;
  for (const description::GivenValue& given : rules.model->description->values) {
    if (given.for_each.empty()) {
      made.push_back({given, false});
      continue;
    }
    std::vector<std::string> devices;
    for (std::uint32_t unit = 0; unit < rules.units.size(); ++unit) {
      const std::string device = upper(rules.model->units[unit].device_path());
      const bool known = std::find(devices.begin(), devices.end(), device) != devices.end();
      if (known || !fits(device, given.for_each)) continue;
      devices.push_back(device);
      made.push_back({value_for(given, rules, unit), true});
    }
  }
  return made;
}

std::vector<std::string> input_texts(const description::GivenValue& given) {
  switch (given.kind) {
    case ValueKind::integral:
    case ValueKind::lag:
    case ValueKind::delay:
    case ValueKind::derivative:
    case ValueKind::is:
      return {given.formula};
    case ValueKind::ramp:
      if (given.down.empty()) return {given.formula, given.up};
      return {given.formula, given.up, given.down};
    case ValueKind::pid:
      return {given.of, given.to};
    case ValueKind::linear:
      return given.u;
    case ValueKind::parameter:
    case ValueKind::position:
    case ValueKind::noise:
      return {};
  }
  return {};
}

double seconds(tables::Time time) { return static_cast<double>(time) / 1e9; }

ValueRules numbers_of(const description::GivenValue& given, const description::Defaults& defaults) {
  ValueRules value;
  value.name = given.name;
  value.kind = given.kind;
  if (given.min) value.min = *given.min;
  if (given.max) value.max = *given.max;
  value.start = given.start.value_or(0);
  value.step = given.kind == ValueKind::parameter ? 0 : given.step.value_or(defaults.step);
  value.trace = given.trace.value_or(100 * tables::kMillisecond);
  if (given.kind == ValueKind::lag) value.factor = 1 - std::exp(-value.h() / seconds(given.time.value_or(0)));
  if (given.kind == ValueKind::noise) value.factor = given.noise;
  if (given.kind == ValueKind::pid) value.factor = given.kp;
  value.ti = seconds(given.ti.value_or(0));
  value.td = seconds(given.td);
  if (given.kind == ValueKind::delay) value.length = static_cast<std::size_t>(given.time.value_or(0) / value.step);
  value.a = given.a;
  value.b = given.b;
  value.c = given.c;
  value.d = given.d;
  if (given.kind == ValueKind::linear) {
    value.outputs = std::max(given.c.size(), given.d.size());
    value.start_states = given.start_states;
    value.start_states.resize(given.a.size());
  }
  return value;
}

/// The numbers of the states of a unit. A rest state that no symbol names may be called `rest`.
void set_position(const Rules& rules, const description::GivenValue& given, ValueRules& value) {
  value.unit = kNone;
  for (std::uint32_t i = 0; i < rules.units.size(); ++i) {
    if (same_name(rules.units[i].path, given.formula)) value.unit = i;
  }
  if (value.unit == kNone) throw std::runtime_error("device `" + given.formula + "` not found");
  const UnitRules& unit = rules.units[value.unit];
  const auto number = [&](const std::string& name) {
    return std::find_if(given.at.begin(), given.at.end(), [&](const auto& at) { return same_name(at.first, name); });
  };
  for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
    const StateRules& state = unit.states[i];
    auto found = number(state.name);
    const bool unnamed = state.operation == kNone && state.event == kNone;
    if (found == given.at.end() && unnamed && unit.any_rest == i) found = number("rest");
    if (found == given.at.end()) throw std::runtime_error("no number of state `" + state.name + "`");
    value.at.push_back(found->second);
  }
}

void set_formulas(const Rules& rules, const description::GivenValue& given, ValueRules& value) {
  for (const std::string& text : input_texts(given)) resolve(rules, value.inputs.emplace_back(parse_formula(text)));
  for (const description::GivenChange& change : given.changes) {
    ChangeRules& made = value.changes.emplace_back();
    made.when = parse_condition(change.when);
    made.to = parse_formula(change.to);
    resolve(rules, made.when);
    resolve(rules, made.to);
  }
  if (given.kind == ValueKind::position) set_position(rules, given, value);
}

/// Fills in what the names of all values are needed for. The index of an entry that must be left out; else kNone.
std::uint32_t set_all_formulas(Rules& rules, const std::vector<MadeValue>& made) {
  for (std::uint32_t i = 0; i < made.size(); ++i) {
    try {
      set_formulas(rules, made[i].given, rules.values[i]);
    } catch (const std::runtime_error& error) {
      if (made[i].of_pattern) return i;
      rules.fault = "value " + made[i].given.name + ": " + error.what();
    }
  }
  return kNone;
}

void add_texts_of_devices(const description::Description& description, std::vector<std::string>& texts) {
  for (const description::DeviceDescription& device : description.devices) {
    for (const description::GivenTransition& each : device.transitions) {
      texts.push_back(each.when);
      texts.push_back(each.during);
      for (const auto& time : {each.after, each.takes}) {
        if (time && time->formula) texts.push_back(*time->formula);
      }
    }
    for (const auto& [name, condition] : device.inputs) texts.push_back(condition);
  }
  for (const description::GivenFollow& each : description.follow) {
    texts.insert(texts.end(), {each.condition, each.off});
  }
  for (const description::GivenRequirement& each : description.requirements) {
    texts.insert(texts.end(), {each.never, each.after, each.expect});
  }
  for (const description::GivenMalfunction& each : description.malfunctions) {
    texts.push_back(each.when);
    if (each.becomes) texts.push_back(each.becomes->unless);
  }
}

void add_texts_of_material(const description::GivenMaterial& material, std::vector<std::string>& texts) {
  for (const description::GivenTrack& track : material.tracks) {
    for (const description::GivenDrive& each : track.drives) {
      texts.push_back(each.forward);
      texts.push_back(each.backward);
    }
    for (const description::GivenStop& each : track.stops) texts.push_back(each.when);
    for (const description::GivenEnd& each : track.ends) texts.push_back(each.when);
  }
  for (const description::GivenTransfer& each : material.transfers) texts.push_back(each.when);
  for (const description::GivenWork& each : material.work) texts.push_back(each.when);
  for (const description::GivenSource& each : material.sources) texts.push_back(each.when);
}

/// All formulas and conditions of the description, as texts.
std::vector<std::string> all_texts(const Rules& rules, const std::vector<MadeValue>& made) {
  std::vector<std::string> texts;
  for (const MadeValue& each : made) {
    for (const std::string& text : input_texts(each.given)) texts.push_back(text);
    for (const description::GivenChange& change : each.given.changes) {
      texts.push_back(change.when);
      texts.push_back(change.to);
    }
  }
  for (const description::GivenSignal& signal : rules.model->description->signals) texts.push_back(signal.of);
  add_texts_of_devices(*rules.model->description, texts);
  add_texts_of_material(rules.model->description->material, texts);
  return texts;
}

/// A text without quotes, and without blanks within names.
std::string bare_names(const std::string& text) {
  std::string bare;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') continue;
    const std::size_t next = text[i] == ' ' ? text.find_first_not_of(" '", i) : text.npos;
    const bool before_sign = next != text.npos && std::string_view(".[]").find(text[next]) != std::string_view::npos;
    const bool after_sign = text[i] == ' ' && !bare.empty() && (bare.back() == '.' || bare.back() == '[');
    if (!before_sign && !after_sign) bare += text[i];
  }
  return bare;
}

/// Whether a text names an output.
bool names_output(const std::string& text, const std::string& output) {
  const std::string bare = upper(bare_names(text));
  const std::string wanted = upper(output);
  for (std::size_t at = bare.find(wanted); at != std::string::npos; at = bare.find(wanted, at + 1)) {
    const char before = at == 0 ? ' ' : bare[at - 1];
    if (before != '.' && before != '_' && std::isalnum(static_cast<unsigned char>(before)) == 0) return true;
  }
  return false;
}

/// The outputs in the trace: those that are named, else the first one.
std::vector<std::uint32_t> traced_of(const ValueRules& value, const std::vector<std::string>& texts) {
  if (value.trace == 0) return {};
  std::vector<std::uint32_t> traced;
  for (std::uint32_t i = 0; value.outputs > 1 && i < value.outputs; ++i) {
    const std::string name = value.output_name(i);
    const bool named =
        std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return names_output(text, name); });
    if (named) traced.push_back(i);
  }
  if (traced.empty()) traced.push_back(0);
  return traced;
}

void set_time_formula(Rules& rules, const UnitRules& unit, const description::Duration& time, Formula& formula) {
  if (time.kind != description::Duration::Kind::seconds) return;
  try {
    formula = parse_formula(*time.formula);
    resolve(rules, formula);
  } catch (const std::runtime_error& error) {
    rules.fault = unit.path + ": " + error.what();
  }
}

}  // namespace

void derive_values(Rules& rules) {
  std::vector<MadeValue> made = made_values(rules);
  for (std::uint32_t left_out = 0; left_out != kNone;) {
    rules.values.clear();
    for (const MadeValue& each : made) {
      rules.values.push_back(numbers_of(each.given, rules.model->description->defaults));
    }
    left_out = set_all_formulas(rules, made);
    if (left_out != kNone) made.erase(made.begin() + left_out);
  }
  for (UnitRules& unit : rules.units) {
    for (Transition& transition : unit.transitions) {
      set_time_formula(rules, unit, transition.after, transition.after_formula);
      set_time_formula(rules, unit, transition.takes, transition.takes_formula);
    }
  }
  const std::vector<std::string> texts = all_texts(rules, made);
  for (ValueRules& value : rules.values) value.traced = traced_of(value, texts);
  for (SignalRules& signal : rules.signals) {
    try {
      resolve(rules, signal.of);
    } catch (const std::runtime_error& error) {
      rules.fault = std::string(rules.model->symbols[signal.symbol].name()) + ": " + error.what();
    }
  }
}

}  // namespace symplant::reference
