// Computes values and signals at whole multiples of their steps. Compiled without contraction of operations, so that
// each gives the same bits everywhere.
#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/formula.hpp"

namespace symplant::engine {
namespace {

using tables::ValueKind;

bool same(double a, double b) noexcept { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Limited, and never -0.
double limited(double number, double min, double max) noexcept {
  const double result = number < min ? min : number > max ? max : number;
  return result == 0 ? 0.0 : result;
}

/// The step in seconds.
double seconds(tables::Time step) noexcept { return static_cast<double>(step) / 1e9; }

/// The sum of two products of a row and a column, from the first product on.
double product(const double* a, const double* x, std::uint32_t states, const double* b, const double* u,
               std::uint32_t inputs) noexcept {
  double sum = 0;
  for (std::uint32_t i = 0; i < states; ++i) sum = i == 0 ? a[i] * x[i] : sum + a[i] * x[i];
  for (std::uint32_t i = 0; i < inputs; ++i) sum = states + i == 0 ? b[i] * u[i] : sum + b[i] * u[i];
  return sum;
}

/// The least and the greatest number of a type.
struct Range {
  double low;
  double high;
};

Range range_of(tables::DataType type) noexcept {
  using tables::DataType;
  switch (type) {
    case DataType::boolean:
      return {0, 1};
    case DataType::sint:
      return {-128, 127};
    case DataType::int_:
      return {-32'768, 32'767};
    case DataType::dint:
      return {-2'147'483'648.0, 2'147'483'647.0};
    case DataType::lint:
      return {-9'223'372'036'854'775'808.0, 9'223'372'036'854'775'807.0};
    case DataType::usint:
    case DataType::byte:
      return {0, 255};
    case DataType::uint:
    case DataType::word:
      return {0, 65'535};
    case DataType::udint:
    case DataType::dword:
      return {0, 4'294'967'295.0};
    case DataType::ulint:
    case DataType::lword:
      return {0, 18'446'744'073'709'551'615.0};
    case DataType::real:
      return {-static_cast<double>(FLT_MAX), static_cast<double>(FLT_MAX)};
    case DataType::lreal:
      break;
  }
  return {-DBL_MAX, DBL_MAX};
}

/// A whole number as the 64 bits of a slot; the largest 64-bit numbers are not doubles.
std::uint64_t whole_bits(double number, tables::DataType type) noexcept {
  if (number >= 18'446'744'073'709'551'616.0) return ~std::uint64_t{0};
  if (type == tables::DataType::lint && number >= 9'223'372'036'854'775'808.0) return ~std::uint64_t{0} >> 1;
  if (number < 0) return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  return static_cast<std::uint64_t>(number);
}

}  // namespace

tables::Time Values::now() const noexcept { return engine_.head_->now; }

bool Values::is_due(std::uint32_t group) const noexcept { return group != tables::kNone && due_groups_[group] != 0; }

void Values::begin_instant() noexcept {
  const bool first = head_->instant != now();
  head_->instant = now();
  due_ = shows_ = false;
  for (std::uint32_t t = 0; t < index_.trace_count; ++t) {
    if (traces_[t] == 0 || now() % index_.traces[t] != 0) continue;
    traces_[t] = 0;
    shows_ = true;
  }
  if (!first) return;
  if (head_->computed == 0) due_ = shows_ = true;
  for (std::uint32_t g = 0; g < index_.group_count; ++g) {
    due_groups_[g] = now() % index_.steps[g] == 0 ? 1 : 0;
    due_ = due_ || due_groups_[g] != 0;
  }
}

double Values::evaluate(std::uint32_t formula) noexcept {
  const tables::FormulaRow& row = tables_->formulas[formula];
  for (std::uint32_t i = row.inputs.first; i < row.inputs.first + row.inputs.count; ++i) {
    if (tables_->inputs[i].kind == tables::FormulaInputKind::time) inputs_[i] = static_cast<double>(now()) / 1e9;
  }
  return tables::evaluate(tables_->steps.subspan(row.steps.first, row.steps.count), tables_->numbers,
                          inputs_ + row.inputs.first);
}

/// Gives an output a number that is limited already. `passes_on`: the readers see it at once.
void Values::give(std::uint32_t output, double number, bool passes_on) noexcept {
  if (same(outputs_[output], number)) return;
  outputs_[output] = number;
  const std::uint32_t value = index_.value_of_output[output];
  moved_[value] = 1;
  shown_outputs_.mark(output);
  const std::uint32_t trace = index_.trace_of[value];
  if (trace != tables::kNone && traces_[trace] == 0 && now() % index_.traces[trace] != 0) {
    traces_[trace] = 1;
    if (!computing_) set_wheel();
  }
  if (passes_on) {
    pass_on(output);
  } else {
    changed_outputs_.mark(output);
    engine_.unpublished_ = true;
  }
}

void Values::pass_on(std::uint32_t output) noexcept {
  for (const std::uint32_t input : index_.of_output.of(output)) set_input(input, outputs_[output]);
  for (const std::uint32_t reader : index_.comparisons_of_output.of(output)) compare(reader / 2);
  if (engine_.flow_.active()) engine_.flow_.output_changed(output);
}

/// Calls `function(owner)` for each owner in some ranks that is awake, due and not frozen, in the order of ranks; also
/// for those that a call wakes.
template <class Function>
void Values::for_due(std::uint32_t begin, std::uint32_t end, Function function) noexcept {
  for (std::uint32_t rank = begin; rank < end;) {
    const std::uint64_t bits = awake_[rank / 64] >> (rank % 64);
    if (bits == 0) {
      rank = (rank / 64 + 1) * 64;
      continue;
    }
    rank += static_cast<std::uint32_t>(std::countr_zero(bits));
    if (rank >= end) return;
    const std::uint32_t owner = index_.owner_at[rank++];
    if (!is_due(index_.group_of[owner])) continue;
    if (owner < index_.value_count && states_[owner].frozen != 0) continue;
    function(owner);
  }
}

void Values::compute() noexcept {
  due_ = false;
  if (head_->computed == 0) {
    head_->computed = 1;
    compares_all_ = engine_.unpublished_ = true;
  }
  computing_ = true;
  const std::uint32_t values = index_.value_count;
  if (now() != 0) {
    for_due(0, values, [this](std::uint32_t value) {
      if (states_[value].stored != 0 && states_[value].set_at != now() && !step(value)) failed_[value] = 1;
    });
  }
  for_due(0, values, [this](std::uint32_t value) {
    if (!compute(value)) failed_[value] = 1;
  });
  for_due(0, values, [this](std::uint32_t value) {
    if (!store(value)) failed_[value] = 1;
  });
  compute_signals();
  for_due(0, values, [this](std::uint32_t value) { close(value); });
  computing_ = false;
  set_wheel();
}

/// The end of a value's computation: the finding, and whether it may sleep.
void Values::close(std::uint32_t value) noexcept {
  set_finite(value, failed_[value] == 0);
  const tables::ValueRow& row = tables_->rows[value];
  bool sleeps = index_.timed[value] == 0;
  if (row.kind == ValueKind::position) {
    sleeps = sleeps && inputs_[tables_->formulas[row.formula].inputs.first] == 0;  // it does not move
  } else if (row.kind == ValueKind::noise) {
    sleeps = false;
  } else if (row.kind != ValueKind::is) {
    // A step that fails again must be seen even if the inputs change in the same computation.
    sleeps = sleeps && moved_[value] == 0 && failed_[value] == 0 && now() != 0 && states_[value].set_at != now();
  }
  if (sleeps) sleep(value);
  failed_[value] = moved_[value] = 0;
}

/// The step from the stored inputs; false if a result is not finite.
bool Values::step(std::uint32_t value) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  const double h = seconds(row.step);
  const double x = outputs_[row.output];
  const double u = stored_[row.formula];
  double result = 0;
  switch (row.kind) {
    case ValueKind::integral:
      result = x + h * u;
      break;
    case ValueKind::lag:
      result = x + (u - x) * row.factor;
      break;
    case ValueKind::ramp: {
      const double up = stored_[row.formula + 1];
      const double down = stored_[row.formula + row.formulas - 1];
      const double d = u - x;
      result = d > up * h ? x + up * h : d < -(down * h) ? x - down * h : u;
      break;
    }
    case ValueKind::delay:
      result = memory(value)[states_[value].oldest];
      break;
    case ValueKind::linear:
      return step_linear(row, value);
    default:
      return true;
  }
  if (!std::isfinite(result)) return false;
  give(row.output, limited(result, row.min, row.max), true);
  return true;
}

/// Sums run over states first, then inputs, from the first product on.
bool Values::step_linear(const tables::ValueRow& row, std::uint32_t value) noexcept {
  const std::uint32_t n = row.states;
  const double* const a = &tables_->numbers[row.numbers + n];
  const double* const b = a + std::size_t{n} * n;
  double* const x = memory(value);
  for (std::uint32_t i = 0; i < n; ++i) {
    results_[i] =
        product(a + std::size_t{i} * n, x, n, b + std::size_t{i} * row.formulas, &stored_[row.formula], row.formulas);
    if (!std::isfinite(results_[i])) return false;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!same(x[i], results_[i])) moved_[value] = 1;
    x[i] = results_[i];
  }
  return true;
}

/// Outputs that are computed from others; false if a result is not finite.
bool Values::compute(std::uint32_t value) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  double result = 0;
  switch (row.kind) {
    case ValueKind::is:
      result = evaluate(row.formula);
      break;
    case ValueKind::position:
      result = position(row);
      break;
    case ValueKind::noise:
      result = row.factor * normal(names_[value], states_[value].draws);
      break;
    case ValueKind::derivative:
      return compute_derivative(row, value);
    case ValueKind::pid:
      return compute_pid(row, value);
    case ValueKind::linear:
      return compute_linear(row, value);
    default:
      return true;
  }
  if (!std::isfinite(result)) return false;
  give(row.output, limited(result, row.min, row.max), true);
  return true;
}

bool Values::compute_derivative(const tables::ValueRow& row, std::uint32_t value) noexcept {
  const double u = evaluate(row.formula);
  double& last = *memory(value);
  ValueState& state = states_[value];
  const double result = state.remembers != 0 ? (u - last) / seconds(row.step) : 0;
  if (!std::isfinite(u) || !std::isfinite(result)) return false;
  if (state.remembers == 0 || !same(last, u)) moved_[value] = 1;
  last = u;
  state.remembers = 1;
  give(row.output, limited(result, row.min, row.max), true);
  return true;
}

bool Values::compute_pid(const tables::ValueRow& row, std::uint32_t value) noexcept {
  const double of = evaluate(row.formula);
  const double e = evaluate(row.formula + 1) - of;
  const double h = seconds(row.step);
  ValueState& state = states_[value];
  double& last = memory(value)[0];
  double& integral = memory(value)[1];
  const double d = state.remembers != 0 ? (last - of) / h : 0;
  const double w = row.factor * (e + integral + row.td * d);
  const double gain = row.factor * e;
  const bool winds_up = (w > row.max && gain > 0) || (w < row.min && gain < 0);
  const double next = row.ti == 0 || winds_up ? integral : integral + e * h / row.ti;
  if (!std::isfinite(of) || !std::isfinite(w) || !std::isfinite(next)) return false;
  if (state.remembers == 0 || !same(last, of) || !same(integral, next)) moved_[value] = 1;
  state.remembers = 1;
  last = of;
  integral = next;
  give(row.output, limited(w, row.min, row.max), true);
  return true;
}

bool Values::compute_linear(const tables::ValueRow& row, std::uint32_t value) noexcept {
  const std::uint32_t n = row.states;
  const std::uint32_t inputs = row.formulas;
  const double* const c = &tables_->numbers[row.numbers + n + std::size_t{n} * n + std::size_t{n} * inputs];
  const double* const d = c + std::size_t{row.outputs} * n;
  double u[16] = {};
  for (std::uint32_t f = 0; row.direct && f < inputs; ++f) u[f] = evaluate(row.formula + f);
  for (std::uint32_t o = 0; o < row.outputs; ++o) {
    results_[o] =
        product(c + std::size_t{o} * n, memory(value), n, d + std::size_t{o} * inputs, u, row.direct ? inputs : 0);
    if (!std::isfinite(results_[o])) return false;
  }
  for (std::uint32_t o = 0; o < row.outputs; ++o) give(row.output + o, limited(results_[o], row.min, row.max), true);
  return true;
}

/// The position of a unit: the number of its state, or one between those of the states that it moves between.
double Values::position(const tables::ValueRow& row) const noexcept {
  const UnitState& unit = engine_.units_[row.unit];
  const double* const at = &tables_->numbers[row.numbers];
  const double from = at[unit.state];
  if ((unit.flags & kMoving) == 0) return from;
  const tables::Time whole = engine_.whole(row.unit);
  const tables::Time left = engine_.remaining(row.unit);
  double p = whole == 0 ? 1.0 : static_cast<double>(whole - left) / static_cast<double>(whole);
  if (left > whole) p = 0;  // it never comes
  return from + (at[unit.target] - from) * p;
}

/// Stores the inputs of the next step; false if one is not finite.
bool Values::store(std::uint32_t value) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  const bool stores = row.kind == ValueKind::integral || row.kind == ValueKind::lag || row.kind == ValueKind::ramp ||
                      row.kind == ValueKind::delay || row.kind == ValueKind::linear;
  if (!stores) return true;
  ValueState& state = states_[value];
  double results[16];
  for (std::uint32_t f = 0; f < row.formulas; ++f) {
    results[f] = evaluate(row.formula + f);
    if (!std::isfinite(results[f])) {
      if (state.stored != 0) moved_[value] = 1;
      state.stored = 0;
      return false;
    }
    if (row.kind == ValueKind::ramp && f != 0 && results[f] <= 0) results[f] = 0;
  }
  if (state.stored == 0) moved_[value] = 1;
  state.stored = 1;
  if (row.kind == ValueKind::delay) {
    store_delayed(row, value, results[0]);
    return true;
  }
  for (std::uint32_t f = 0; f < row.formulas; ++f) {
    if (!same(stored_[row.formula + f], results[f])) moved_[value] = 1;
    stored_[row.formula + f] = results[f];
  }
  return true;
}

/// A delay sleeps once all that it holds is equal to what it shows.
void Values::store_delayed(const tables::ValueRow& row, std::uint32_t value, double u) noexcept {
  ValueState& state = states_[value];
  const double newest = memory(value)[(state.oldest + row.steps - 1) % row.steps];
  state.equal = same(newest, u) ? std::min(state.equal + 1, row.steps) : 1;
  const bool shown = same(outputs_[row.output], limited(u, row.min, row.max));
  if (state.equal < row.steps || !shown) moved_[value] = 1;
  memory(value)[state.oldest] = u;
  state.oldest = (state.oldest + 1) % row.steps;
}

/// All signals are computed, then written.
void Values::compute_signals() noexcept {
  const std::uint32_t begin = index_.value_count;
  const std::uint32_t end = begin + index_.signal_count;
  for_due(begin, end, [this, begin](std::uint32_t owner) {
    const std::uint32_t signal = owner - begin;
    const tables::SignalRow& row = tables_->signals[signal];
    double n = evaluate(row.formula);
    if (row.scaled) n = row.c + (n - row.a) * (row.d - row.c) / (row.b - row.a);
    if (row.noise != 0) n += row.noise * normal(names_[owner], signal_draws_[signal]);
    const tables::SymbolRow& symbol = engine_.tables_.symbols[row.symbol];
    numbers_[signal] = std::isnan(n) ? engine_.event_values_.made[symbol.index] : shown(row, n);
  });
  for_due(begin, end, [this, begin](std::uint32_t owner) {
    const tables::SignalRow& row = tables_->signals[owner - begin];
    engine_.make_event_value(engine_.tables_.symbols[row.symbol].index, numbers_[owner - begin]);
    if (row.noise == 0 && index_.timed[owner] == 0) sleep(owner);
  });
}

/// The bits of a number in the slot of a signal's symbol.
std::uint64_t Values::shown(const tables::SignalRow& row, double number) const noexcept {
  const tables::DataType type = engine_.tables_.symbols[row.symbol].type();
  const Range range = range_of(type);
  const double low = std::max(row.low, range.low);
  const double high = std::min(row.high, range.high);
  number = limited(number, low, high);
  if (type == tables::DataType::lreal) return std::bit_cast<std::uint64_t>(number);
  if (type == tables::DataType::real) {
    return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(number)) + 0.0);  // never -0
  }
  number = limited(std::nearbyint(number), std::ceil(low), std::floor(high));
  return whole_bits(number, type);
}

/// Nearly normal with variance 1, as the sum of twelve uniform numbers.
double Values::normal(std::uint64_t name, std::uint32_t& draws) const noexcept {
  std::uint64_t state = draw_start(engine_.head_->seed, name, 0, draws++);
  std::int64_t sum = -(std::int64_t{6} << 32);
  for (int i = 0; i < 12; ++i) sum += static_cast<std::int64_t>(split_mix(state) >> 32);
  return static_cast<double>(sum) / 4'294'967'296.0;
}

void Values::set_finite(std::uint32_t value, bool finite) noexcept {
  ValueState& state = states_[value];
  if (finite == (state.not_finite == 0)) return;
  state.not_finite = finite ? 0 : 1;
  finite_changes_.mark(value);
  if (!finite) engine_.suspects_ |= suspect(tables::FindingKind::value_not_finite);
}

void Values::activate(std::uint32_t owner) noexcept {
  if (owner == tables::kNone) return;
  const std::uint32_t rank = index_.rank_of[owner];
  const std::uint32_t group = index_.group_of[owner];
  std::uint64_t& word = awake_[rank / 64];
  if (group == tables::kNone || (word & bit_in_word(rank)) != 0) return;
  word |= bit_in_word(rank);
  if (awake_count_[group]++ == 0 && !computing_) set_wheel();
}

void Values::sleep(std::uint32_t owner) noexcept {
  const std::uint32_t rank = index_.rank_of[owner];
  awake_[rank / 64] &= ~bit_in_word(rank);
  --awake_count_[index_.group_of[owner]];
}

/// The next time at which something is due.
void Values::set_wheel() noexcept {
  tables::Time due = tables::kNever;
  const auto next = [this](tables::Time step) { return (now() / step + 1) * step; };
  for (std::uint32_t g = 0; g < index_.group_count; ++g) {
    if (awake_count_[g] != 0) due = std::min(due, next(index_.steps[g]));
  }
  for (std::uint32_t t = 0; t < index_.trace_count; ++t) {
    if (traces_[t] != 0) due = std::min(due, next(index_.traces[t]));
  }
  engine_.set_wheel(entry_, due);
}

}  // namespace symplant::engine
