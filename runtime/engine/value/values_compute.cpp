// Computes values and signals at whole multiples of their steps. Compiled without contraction of operations, so that
// each gives the same bits everywhere.
#include <algorithm>
#include <bit>
#include <cmath>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/formula.hpp"

namespace symplant::engine {
namespace {

using tables::ValueKind;

/// The sum of two products of a row and a column, from the first product on.
double product(const double* a, const double* x, std::uint32_t states, const double* b, const double* u,
               std::uint32_t inputs) noexcept {
  double sum = 0;
  for (std::uint32_t i = 0; i < states; ++i) sum = i == 0 ? a[i] * x[i] : sum + a[i] * x[i];
  for (std::uint32_t i = 0; i < inputs; ++i) sum = states + i == 0 ? b[i] * u[i] : sum + b[i] * u[i];
  return sum;
}

}  // namespace

/// Limited, and never -0.
double Values::limited(double number, double min, double max) noexcept {
  const double result = number < min ? min : number > max ? max : number;
  return result == 0 ? 0.0 : result;
}

tables::Time Values::now() const noexcept { return engine_.head_->now; }

void Values::begin_instant() noexcept {
  const bool first = head_->instant != now();
  head_->instant = now();
  due_ = shows_ = false;
  for (std::uint32_t t = 0; t < index_.trace_count; ++t) {
    off_trace_[t] = now() % index_.traces[t] != 0 ? 1 : 0;
    if (traces_[t] == 0 || off_trace_[t] != 0) continue;
    traces_[t] = 0;
    shows_ = true;
  }
  if (index_.reads_time) seen_[index_.time_slot] = static_cast<double>(now()) / 1e9;
  if (!first) return;
  if (head_->computed == 0) due_ = shows_ = true;
  all_due_ = true;
  for (std::uint32_t g = 0; g < index_.group_count; ++g) {
    due_groups_[g] = now() % index_.steps[g] == 0 ? 1 : 0;
    due_ = due_ || due_groups_[g] != 0;
    all_due_ = all_due_ && due_groups_[g] != 0;
  }
}

tables::Time Values::time_of(std::uint32_t formula) noexcept {
  const double result = evaluate(formula);
  if (!(result > 0)) return 0;
  return static_cast<tables::Time>(std::floor(std::min(result, 1e9) * 1e9));
}

/// An output changed in this instant.
SYMPLANT_ALWAYS_INLINE void Values::note_change(std::uint32_t output) noexcept {
  changed_ = true;
  unshown_[output / 64] |= bit_in_word(output);
  if (watched_) widen(output);
  const std::uint32_t trace = index_.uses[output].trace;
  traces_[trace] |= off_trace_[trace];
}

void Values::widen(std::uint32_t output) noexcept {
  ranges_[output].least = std::min(ranges_[output].least, outputs_[output]);
  ranges_[output].greatest = std::max(ranges_[output].greatest, outputs_[output]);
}

std::span<const std::uint32_t> Values::take_shown() noexcept {
  shown_.size = 0;
  for (std::uint32_t word = 0; active_ && word < (tables_->outputs + 63) / 64; ++word) {
    for (std::uint64_t bits = unshown_[word]; bits != 0; bits &= bits - 1) {
      const std::uint32_t output = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      if (off_trace_[index_.uses[output].trace] != 0) continue;
      unshown_[word] &= ~bit_in_word(output);
      if (index_.uses[output].trace != index_.trace_count) shown_.add(output);
    }
  }
  return shown_.view();
}

/// Gives an output a number that is limited already; its readers see it at the end of the round.
void Values::give_later(std::uint32_t output, double number) noexcept {
  if (same(outputs_[output], number)) return;
  outputs_[output] = number;
  const std::uint32_t trace = index_.uses[output].trace;
  const bool shown_now = trace == index_.trace_count || now() % index_.traces[trace] == 0;
  off_trace_[trace] = shown_now ? 0 : 1;  // between two instants it is that of an earlier time
  const bool waits = shown_now || traces_[trace] != 0;
  note_change(output);
  if (!waits) set_wheel();
  changed_outputs_.mark(output);
  engine_.unpublished_ = true;
}

SYMPLANT_ALWAYS_INLINE void Values::pass_on(std::uint32_t output) noexcept {
  seen_[output] = outputs_[output];
  const OutputUse& use = index_.uses[output];
  for (std::uint32_t r = use.readers; r < use.readers_end; ++r) {
    const std::uint32_t rank = index_.output_readers[r];
    if (!is_awake(rank)) wake(rank);
  }
  if (use.others) pass_on_further(output);
}

void Values::pass_on_further(std::uint32_t output) noexcept {
  for (const std::uint32_t reader : index_.comparisons_of_output.of(output)) compare(reader / 2);
  if (engine_.flow_.active()) engine_.flow_.output_changed(output);
}

/// A jump is seen at the end of its round.
void Values::pass_on_later() noexcept {
  changed_outputs_.take_all([this](std::uint32_t output) { pass_on(output); });
}

void Values::compute() noexcept {
  due_ = false;
  const bool first = head_->computed == 0;
  head_->computed = 1;
  computing_ = true;
  if (now() != 0) for_due(index_.stepping, [this](std::uint32_t rank) { passes_[rank] = step(index_.step_at[rank]); });
  for_due(index_.computed, [this](std::uint32_t rank) { compute(rank); });
  for_due(index_.stepping, [this](std::uint32_t rank) {
    const Pass pass = passes_[rank] | store(index_.step_at[rank]);
    passes_[rank] = 0;
    close(rank, pass);
  });
  compute_signals();
  computing_ = false;
  for (std::uint32_t c = 0; first && c < tables_->comparisons.size(); ++c) compare(c);
  if (first && watched_) watch();  // what is computed has had no number yet
  set_wheel();
}

/// The end of a value's computation: the finding, and whether it may sleep. A step that fails again must be seen even
/// if the inputs change in the same computation.
SYMPLANT_ALWAYS_INLINE void Values::close(std::uint32_t rank, Pass pass) noexcept {
  const ValueStep& step = index_.step_at[rank];
  const ValueState& state = states_[step.value];
  if (((pass & kFailed) | state.not_finite) != 0) set_finite(step.value, (pass & kFailed) == 0);
  if (pass == 0 && !step.timed && now() != 0 && state.set_at != now()) sleep(rank);
}

/// Limits a result, and gives it to the output; the readers see it at once.
SYMPLANT_ALWAYS_INLINE Values::Pass Values::give(const ValueStep& step, double result) noexcept {
  if (result > step.min && result < step.max) {
    result += 0.0;  // never -0
  } else if (std::isfinite(result)) {
    result = limited(result, step.min, step.max);
  } else {
    return kFailed;
  }
  if (same(outputs_[step.output], result)) return 0;
  outputs_[step.output] = result;
  note_change(step.output);
  pass_on(step.output);
  return kMoved;
}

/// The step from the stored inputs.
SYMPLANT_ALWAYS_INLINE Values::Pass Values::step(const ValueStep& step) noexcept {
  const ValueState& state = states_[step.value];
  if (state.stored == 0 || state.set_at == now()) return 0;
  const double x = outputs_[step.output];
  const double u = stored_[step.formula];
  switch (step.kind) {
    case ValueKind::integral:
      return give(step, x + step.h * u);
    case ValueKind::lag:
      return give(step, x + (u - x) * step.factor);
    case ValueKind::ramp: {
      const double up = stored_[step.formula + 1];
      const double down = stored_[step.formula + step.formulas - 1];
      const double d = u - x;
      return give(step, d > up * step.h ? x + up * step.h : d < -(down * step.h) ? x - down * step.h : u);
    }
    case ValueKind::delay:
      return give(step, memory(step.value)[state.oldest]);
    case ValueKind::linear:
      return step_linear(step);
    default:
      return 0;
  }
}

/// Sums run over states first, then inputs, from the first product on.
Values::Pass Values::step_linear(const ValueStep& step) noexcept {
  const tables::ValueRow& row = tables_->rows[step.value];
  const std::uint32_t n = row.states;
  const double* const a = &tables_->numbers[row.numbers + n];
  const double* const b = a + std::size_t{n} * n;
  double* const x = memory(step.value);
  for (std::uint32_t i = 0; i < n; ++i) {
    results_[i] =
        product(a + std::size_t{i} * n, x, n, b + std::size_t{i} * row.formulas, &stored_[row.formula], row.formulas);
    if (!std::isfinite(results_[i])) return kFailed;
  }
  Pass pass = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!same(x[i], results_[i])) pass = kMoved;
    x[i] = results_[i];
  }
  return pass;
}

/// An output that is computed from others.
void Values::compute(std::uint32_t rank) noexcept {
  const ValueStep& step = index_.step_at[rank];
  switch (step.kind) {
    case ValueKind::is:
      return close(rank, give(step, evaluate(step.formula)));
    case ValueKind::position: {
      const tables::ValueRow& row = tables_->rows[step.value];
      const bool moving = seen_[index_.slots[tables_->formulas[step.formula].inputs.first]] != 0;
      return close(rank, give(step, position(row)) | (moving ? kMoved : Pass{0}));
    }
    case ValueKind::noise:
      return close(rank, give(step, step.factor * normal(names_[step.value], states_[step.value].draws)) | kMoved);
    case ValueKind::derivative:
      return close(rank, compute_derivative(step));
    case ValueKind::pid:
      return close(rank, compute_pid(step));
    default:
      passes_[rank] |= compute_linear(step);  // store() follows
  }
}

Values::Pass Values::compute_derivative(const ValueStep& step) noexcept {
  const double u = evaluate(step.formula);
  double& last = *memory(step.value);
  ValueState& state = states_[step.value];
  const double result = state.remembers != 0 ? (u - last) / step.h : 0;
  if (!std::isfinite(u) || !std::isfinite(result)) return kFailed;
  const Pass pass = state.remembers == 0 || !same(last, u) ? kMoved : 0;
  last = u;
  state.remembers = 1;
  return pass | give(step, result);
}

Values::Pass Values::compute_pid(const ValueStep& step) noexcept {
  const tables::ValueRow& row = tables_->rows[step.value];
  const double of = evaluate(step.formula);
  const double e = evaluate(step.formula + 1) - of;
  ValueState& state = states_[step.value];
  double& last = memory(step.value)[0];
  double& integral = memory(step.value)[1];
  const double d = state.remembers != 0 ? (last - of) / step.h : 0;
  const double w = step.factor * (e + integral + row.td * d);
  const double gain = step.factor * e;
  const bool winds_up = (w > step.max && gain > 0) || (w < step.min && gain < 0);
  const double next = row.ti == 0 || winds_up ? integral : integral + e * step.h / row.ti;
  if (!std::isfinite(of) || !std::isfinite(w) || !std::isfinite(next)) return kFailed;
  const Pass pass = state.remembers == 0 || !same(last, of) || !same(integral, next) ? kMoved : 0;
  state.remembers = 1;
  last = of;
  integral = next;
  return pass | give(step, w);
}

Values::Pass Values::compute_linear(const ValueStep& step) noexcept {
  const tables::ValueRow& row = tables_->rows[step.value];
  const std::uint32_t n = row.states;
  const std::uint32_t inputs = row.formulas;
  const double* const c = &tables_->numbers[row.numbers + n + std::size_t{n} * n + std::size_t{n} * inputs];
  const double* const d = c + std::size_t{row.outputs} * n;
  double u[tables::kMostLinear] = {};
  for (std::uint32_t f = 0; row.direct && f < inputs; ++f) u[f] = evaluate(row.formula + f);
  for (std::uint32_t o = 0; o < row.outputs; ++o) {
    results_[o] =
        product(c + std::size_t{o} * n, memory(step.value), n, d + std::size_t{o} * inputs, u, row.direct ? inputs : 0);
    if (!std::isfinite(results_[o])) return kFailed;
  }
  Pass pass = 0;
  ValueStep one = step;
  for (std::uint32_t o = 0; o < row.outputs; ++o, ++one.output) pass |= give(one, results_[o]);
  return pass;
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

/// Stores the input of the next step.
SYMPLANT_ALWAYS_INLINE Values::Pass Values::store(const ValueStep& step) noexcept {
  if (step.formulas != 1) return store_all(step);
  const double u = evaluate(step.formula);
  ValueState& state = states_[step.value];
  const Pass news = state.stored == 0 ? kMoved : 0;
  if (!std::isfinite(u)) {
    state.stored = 0;
    return kFailed | (news ^ kMoved);
  }
  state.stored = 1;
  if (step.kind == ValueKind::delay) return news | store_delayed(step, u);
  double& stored = stored_[step.formula];
  if (same(stored, u)) return news;
  stored = u;
  return kMoved;
}

/// Stores several inputs, or none if one is not finite.
Values::Pass Values::store_all(const ValueStep& step) noexcept {
  ValueState& state = states_[step.value];
  double results[tables::kMostLinear];
  Pass pass = state.stored == 0 ? kMoved : 0;
  for (std::uint32_t f = 0; f < step.formulas; ++f) {
    results[f] = evaluate(step.formula + f);
    if (!std::isfinite(results[f])) {
      state.stored = 0;
      return kFailed | (pass ^ kMoved);
    }
    if (step.kind == ValueKind::ramp && f != 0 && results[f] <= 0) results[f] = 0;
  }
  state.stored = 1;
  for (std::uint32_t f = 0; f < step.formulas; ++f) {
    if (!same(stored_[step.formula + f], results[f])) pass = kMoved;
    stored_[step.formula + f] = results[f];
  }
  return pass;
}

/// A delay sleeps once all that it holds is equal to what it shows.
Values::Pass Values::store_delayed(const ValueStep& step, double u) noexcept {
  ValueState& state = states_[step.value];
  const std::uint32_t steps = tables_->rows[step.value].steps;
  double* const held = memory(step.value);
  const double newest = held[state.oldest == 0 ? steps - 1 : state.oldest - 1];
  state.equal = same(newest, u) ? std::min(state.equal + 1, steps) : 1;
  const bool shown = same(outputs_[step.output], limited(u, step.min, step.max));
  held[state.oldest] = u;
  state.oldest = state.oldest + 1 == steps ? 0 : state.oldest + 1;
  return state.equal < steps || !shown ? kMoved : 0;
}

/// Nearly normal, with mean 0 and variance 1.
double Values::normal(std::uint64_t name, std::uint32_t& draws) const noexcept {
  std::uint64_t state = draw_start(engine_.head_->seed, name, 0, draws++);
  return static_cast<double>(normal_sum(state)) / 4'294'967'296.0;
}

void Values::set_finite(std::uint32_t value, bool finite) noexcept {
  ValueState& state = states_[value];
  if (finite == (state.not_finite == 0)) return;
  state.not_finite = finite ? 0 : 1;
  finite_changes_.mark(value);
  if (!finite) engine_.suspects_ |= suspect(tables::FindingKind::value_not_finite);
}

/// It may change at its next computation. A parameter has none, and what is frozen stays as it is.
void Values::wake(std::uint32_t rank) noexcept {
  const std::uint32_t group = index_.group_at[rank];
  if (group == tables::kNone || (rank < index_.value_count && states_[index_.step_at[rank].value].frozen != 0)) return;
  awake_[rank / 64] |= bit_in_word(rank);
  if (awake_count_[group]++ == 0 && !computing_) set_wheel();
}

void Values::sleep(std::uint32_t rank) noexcept {
  awake_[rank / 64] &= ~bit_in_word(rank);
  --awake_count_[index_.group_at[rank]];
}

/// The next time at which something is due.
void Values::set_wheel() noexcept {
  tables::Time due = tables::kNever;
  const auto next = [this](tables::Time step) { return later(now() - now() % step, step); };
  for (std::uint32_t g = 0; g < index_.group_count; ++g) {
    if (awake_count_[g] != 0) due = std::min(due, next(index_.steps[g]));
  }
  for (std::uint32_t t = 0; t < index_.trace_count; ++t) {
    if (traces_[t] != 0) due = std::min(due, next(index_.traces[t]));
  }
  engine_.set_wheel(entry_, due);
}

}  // namespace symplant::engine
