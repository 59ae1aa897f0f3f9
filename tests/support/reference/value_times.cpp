// The start of values, when an instant happens because of values and signals, and what the trace gets of them.
#include <algorithm>

#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// The next whole multiple of a step whose first instant is still to come.
Time next_multiple(const World& world, Time step) {
  if (is_due(world, step)) return world.time;
  return later(world.time, step - world.time % step);
}

bool trace_differs(const ValueRules& rules, const ValueWorld& value) {
  for (std::size_t i = 0; i < rules.traced.size(); ++i) {
    if (value.traced.empty() || value.traced[i] != value.outputs[rules.traced[i]]) return true;
  }
  return false;
}

}  // namespace

bool is_due(const World& world, Time step) { return world.time % step == 0 && world.last_instant != world.time; }

std::vector<ValueWorld> first_values(const Rules& rules) {
  std::vector<ValueWorld> values;
  for (const ValueRules& its : rules.values) {
    ValueWorld& value = values.emplace_back();
    // Only kinds that are not computed from others have a start.
    value.outputs.assign(its.outputs, limited(its, its.start));
    value.ring.assign(its.length, value.outputs[0]);
    value.states = its.start_states;
    value.truths.resize(its.changes.size());
    value.shown = value.outputs;
  }
  return values;
}

std::vector<std::pair<std::string, double>> traced_values(const Rules& rules, World& world) {
  std::vector<std::pair<std::string, double>> lines;
  for (std::size_t i = 0; i < rules.values.size(); ++i) {
    const ValueRules& its = rules.values[i];
    ValueWorld& value = world.values[i];
    if (its.trace == 0 || world.time % its.trace != 0) continue;
    const bool first = value.traced.empty();
    value.traced.resize(its.traced.size());
    for (std::size_t t = 0; t < its.traced.size(); ++t) {
      const double output = value.outputs[its.traced[t]];
      if (!first && value.traced[t] == output) continue;
      value.traced[t] = output;
      lines.emplace_back(its.output_name(its.traced[t]), output);
    }
  }
  return lines;
}

void end_instant_of_values(World& world) {
  for (ValueWorld& value : world.values) {
    value.was_set = false;
    value.shown = value.outputs;
  }
}

Time next_due_of_values(const Rules& rules, const World& world, bool steps) {
  Time due = tables::kNever;
  for (std::size_t i = 0; i < rules.values.size(); ++i) {
    const ValueRules& its = rules.values[i];
    const ValueWorld& value = world.values[i];
    if (steps && its.step != 0 && !value.frozen) due = std::min(due, next_multiple(world, its.step));
    if (its.trace != 0 && trace_differs(its, value)) due = std::min(due, next_multiple(world, its.trace));
  }
  for (const SignalRules& signal : rules.signals) {
    if (steps) due = std::min(due, next_multiple(world, signal.every));
  }
  return due;
}

std::vector<std::string> value_names(const model::PlantModel& model) {
  std::vector<std::string> names;
  for (const ValueRules& value : derive(model, {}).values) names.push_back(value.name);
  return names;
}

}  // namespace symplant::reference
