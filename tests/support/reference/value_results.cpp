// Values that are computed from others: step 2 of docs/values.md, "When a value is computed".
#include <algorithm>
#include <cmath>

#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::ValueKind;

/// Takes the results of one value: all or none.
bool all_finite(ValueWorld& value, const std::vector<double>& results) {
  const bool finite = std::all_of(results.begin(), results.end(), [](double each) { return std::isfinite(each); });
  if (!finite) value.not_finite = true;
  return finite;
}

void take_output(const ValueRules& rules, ValueWorld& value, double result) {
  if (all_finite(value, {result})) value.outputs[0] = limited(rules, result);
}

void derive_output(const ValueRules& rules, ValueWorld& value, double u) {
  const double result = value.last ? (u - *value.last) / rules.h() : 0;
  if (!all_finite(value, {result, u})) return;
  value.outputs[0] = limited(rules, result);
  value.last = u;
}

double position_of(const Rules& rules, const World& world, std::uint32_t index) {
  const std::vector<double>& at = rules.values[index].at;
  const UnitWorld& unit = world.units[rules.values[index].unit];
  if (!unit.moving) return at[unit.state];
  double share = 1;
  if (unit.whole != 0) share = static_cast<double>(unit.whole - unit.remaining) / static_cast<double>(unit.whole);
  // A time that never comes.
  if (unit.remaining > unit.whole) share = 0;
  return at[unit.state] + (at[unit.target] - at[unit.state]) * share;
}

void control(const ValueRules& rules, ValueWorld& value, double of, double to, Counters& counters) {
  const double e = to - of;
  const double d = value.last ? (*value.last - of) / rules.h() : 0;
  const double kp = rules.factor;
  const double w = kp * (e + value.integral + rules.td * d);
  const bool wound_up = (w > rules.max && kp * e > 0) || (w < rules.min && kp * e < 0);
  double i = value.integral;
  if (!wound_up && rules.ti != 0) i = i + e * rules.h() / rules.ti;
  if (wound_up) ++counters[Counted::pid_wound_up];
  if (!all_finite(value, {w, i, of})) return;
  value.outputs[0] = limited(rules, w);
  value.integral = i;
  value.last = of;
}

void add_row(const std::vector<double>& row, const std::vector<double>& column, std::optional<double>& sum) {
  for (std::size_t i = 0; i < row.size() && i < column.size(); ++i) {
    const double product = row[i] * column[i];
    sum = sum ? *sum + product : product;
  }
}

void compute_outputs(const ValueRules& rules, ValueWorld& value, const std::vector<double>& u) {
  std::vector<double> outputs;
  for (std::size_t i = 0; i < rules.outputs; ++i) {
    std::optional<double> sum;
    if (i < rules.c.size()) add_row(rules.c[i], value.states, sum);
    if (i < rules.d.size()) add_row(rules.d[i], u, sum);
    outputs.push_back(sum.value_or(0));
  }
  if (!all_finite(value, outputs)) return;
  for (std::size_t i = 0; i < outputs.size(); ++i) value.outputs[i] = limited(rules, outputs[i]);
}

void count_result(const ValueRules& rules, const World& world, Counters& counters) {
  switch (rules.kind) {
    case ValueKind::is:
      ++counters[Counted::is_computed];
      return;
    case ValueKind::derivative:
      ++counters[Counted::derivative_computed];
      return;
    case ValueKind::position:
      if (world.units[rules.unit].moving) ++counters[Counted::position_computed];
      return;
    case ValueKind::noise:
      ++counters[Counted::noise_computed];
      return;
    case ValueKind::pid:
      ++counters[Counted::pid_computed];
      return;
    default:
      if (!rules.d.empty()) ++counters[Counted::outputs_computed];
      return;
  }
}

}  // namespace

void compute_result(const Rules& rules, World& world, std::uint32_t index, Counters& counters) {
  const ValueRules& its = rules.values[index];
  ValueWorld& value = world.values[index];
  if (its.steps() && its.kind != ValueKind::linear) return;
  count_result(its, world, counters);
  std::vector<double> u;
  for (const Formula& input : its.inputs) u.push_back(evaluate(input, {rules, world}));
  switch (its.kind) {
    case ValueKind::is:
      return take_output(its, value, u[0]);
    case ValueKind::derivative:
      return derive_output(its, value, u[0]);
    case ValueKind::position:
      return take_output(its, value, position_of(rules, world, index));
    case ValueKind::noise:
      return take_output(its, value, its.factor * draw_gauss(world.seed, its.name, value.draws++));
    case ValueKind::pid:
      return control(its, value, u[0], u[1], counters);
    case ValueKind::linear:
      return compute_outputs(its, value, u);
    default:
      return;
  }
}

}  // namespace symplant::reference
