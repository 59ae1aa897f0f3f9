// The three steps in which values are computed (docs/values.md, "When a value is computed").
#include <algorithm>
#include <cmath>

#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::ValueKind;

bool is_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double each) { return std::isfinite(each); });
}

/// A row of a matrix times a column: from the first product on.
void add_products(const std::vector<double>& row, const std::vector<double>& column, std::optional<double>& sum) {
  for (std::size_t i = 0; i < row.size() && i < column.size(); ++i) {
    const double product = row[i] * column[i];
    sum = sum ? *sum + product : product;
  }
}

double ramped(double x, double h, const std::vector<double>& inputs, Counters& counters) {
  const double u = inputs[0];
  const double up = inputs[1];
  const double down = inputs.back();  // `up` without `down`
  const double d = u - x;
  if (d > up * h) ++counters[Counted::ramp_rose];
  if (d > up * h) return x + up * h;
  if (d < -(down * h)) ++counters[Counted::ramp_fell];
  if (d < -(down * h)) return x - down * h;
  return u;
}

void step_output(const ValueRules& rules, ValueWorld& value, double x, Counters& counters) {
  if (std::isfinite(x)) {
    if (limited(rules, x) != x) ++counters[Counted::value_limited];
    value.outputs[0] = limited(rules, x);
  } else {
    value.not_finite = true;
    ++counters[Counted::step_not_finite];
  }
}

void step_states(const ValueRules& rules, ValueWorld& value) {
  std::vector<double> states;
  for (std::size_t i = 0; i < rules.a.size(); ++i) {
    std::optional<double> sum;
    add_products(rules.a[i], value.states, sum);
    if (i < rules.b.size()) add_products(rules.b[i], value.inputs, sum);
    states.push_back(sum.value_or(0));
  }
  if (is_finite(states)) {
    value.states = states;
  } else {
    value.not_finite = true;
  }
}

/// Step 1 for one value. It reads nothing of other values.
void make_step(const ValueRules& rules, ValueWorld& value, Counters& counters) {
  const double x = value.outputs[0];
  switch (rules.kind) {
    case ValueKind::integral:
      ++counters[Counted::integral_stepped];
      return step_output(rules, value, x + rules.h() * value.inputs[0], counters);
    case ValueKind::lag:
      ++counters[Counted::lag_stepped];
      return step_output(rules, value, x + (value.inputs[0] - x) * rules.factor, counters);
    case ValueKind::ramp:
      ++counters[Counted::ramp_stepped];
      return step_output(rules, value, ramped(x, rules.h(), value.inputs, counters), counters);
    case ValueKind::delay:
      ++counters[Counted::delay_stepped];
      return step_output(rules, value, value.ring.front(), counters);
    case ValueKind::linear:
      ++counters[Counted::linear_stepped];
      return step_states(rules, value);
    default:
      return;
  }
}

/// Step 3 for one value.
void store_inputs(const Rules& rules, World& world, std::uint32_t index) {
  const ValueRules& its = rules.values[index];
  ValueWorld& value = world.values[index];
  std::vector<double> inputs;
  for (const Formula& input : its.inputs) inputs.push_back(evaluate(input, {rules, world}));
  value.stored = is_finite(inputs);
  value.inputs.clear();
  if (!value.stored) {
    value.not_finite = true;
    return;
  }
  if (its.kind == ValueKind::ramp) {
    for (std::size_t i = 1; i < inputs.size(); ++i) inputs[i] = inputs[i] <= 0 ? 0 : inputs[i];
  }
  if (its.kind == ValueKind::delay) {
    value.ring.erase(value.ring.begin());
    value.ring.push_back(inputs[0]);
  }
  value.inputs = inputs;
}

/// The values that `index` reads in step 2 are computed before it.
void compute_after_its_inputs(const Rules& rules, World& world, std::uint32_t index, std::vector<bool>& done,
                              Counters& counters);

void compute_inputs_of(const Rules& rules, World& world, const Formula& formula, std::vector<bool>& done,
                       Counters& counters) {
  if (formula.kind == Formula::Kind::input && formula.input.kind == Input::Kind::output) {
    compute_after_its_inputs(rules, world, formula.input.of, done, counters);
  }
  for (const Formula& child : formula.children) compute_inputs_of(rules, world, child, done, counters);
}

void compute_after_its_inputs(const Rules& rules, World& world, std::uint32_t index, std::vector<bool>& done,
                              Counters& counters) {
  const ValueRules& its = rules.values[index];
  if (done[index]) return;
  done[index] = true;
  const bool reads = !its.steps() || !its.d.empty();
  if (reads) {
    for (const Formula& input : its.inputs) compute_inputs_of(rules, world, input, done, counters);
  }
  if (its.kind == ValueKind::parameter || world.values[index].frozen || !is_due(world, its.step)) return;
  compute_result(rules, world, index, counters);
}

}  // namespace

double limited(const ValueRules& rules, double number) {
  if (number < rules.min) number = rules.min;
  if (number > rules.max) number = rules.max;
  return number == 0 ? 0 : number;
}

void compute_values(const Rules& rules, World& world, Counters& counters) {
  std::vector<std::uint32_t> due;
  for (std::uint32_t i = 0; i < rules.values.size(); ++i) {
    const bool computed = rules.values[i].kind != ValueKind::parameter && !world.values[i].frozen;
    if (computed && is_due(world, rules.values[i].step)) due.push_back(i);
  }
  for (const std::uint32_t i : due) world.values[i].not_finite = false;
  for (const std::uint32_t i : due) {
    ValueWorld& value = world.values[i];
    if (world.time == 0 || !rules.values[i].steps()) continue;
    if (value.was_set) ++counters[Counted::value_set_before_its_step];
    if (!value.stored) ++counters[Counted::value_without_stored_input];
    if (!value.stored || value.was_set) continue;
    ++counters[Counted::value_stepped];
    make_step(rules.values[i], value, counters);
  }
  std::vector<bool> done(rules.values.size());
  for (std::uint32_t i = 0; i < rules.values.size(); ++i) compute_after_its_inputs(rules, world, i, done, counters);
  for (const std::uint32_t i : due) {
    if (rules.values[i].steps()) store_inputs(rules, world, i);
  }
}

}  // namespace symplant::reference
