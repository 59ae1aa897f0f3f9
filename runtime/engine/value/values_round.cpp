// Jumps of values, and what the engine passes to values and what values pass on.
#include <bit>
#include <cmath>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/formula.hpp"

namespace symplant::engine {

using tables::ValueKind;

namespace {

double limited(const tables::ValueRow& row, double number) noexcept {
  const double result = number < row.min ? row.min : number > row.max ? row.max : number;
  return result == 0 ? 0.0 : result;
}

bool same(double a, double b) noexcept { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool may_be_set(ValueKind kind) noexcept {
  return kind == ValueKind::parameter || kind == ValueKind::integral || kind == ValueKind::lag ||
         kind == ValueKind::ramp;
}

}  // namespace

void Values::set_input(std::uint32_t input, double number) noexcept {
  if (std::bit_cast<std::uint64_t>(inputs_[input]) == std::bit_cast<std::uint64_t>(number)) return;
  inputs_[input] = number;
  activate(index_.owner_of_input[input]);
}

void Values::condition_changed(tables::ReaderKind kind, std::uint32_t reader, bool truth) noexcept {
  if (kind == tables::ReaderKind::change) {
    due_changes_.mark(reader);
  } else {
    set_input(reader, truth ? 1 : 0);
  }
}

void Values::value_changed(tables::Direction direction, std::uint32_t slot, std::uint64_t value) noexcept {
  const Readers& readers =
      direction == tables::Direction::operation ? index_.of_operation_value : index_.of_event_value;
  for (const std::uint32_t input : readers.of(slot)) {
    set_input(input, tables::number_of(tables_->inputs[input].number, value));
  }
  compares_all_ = true;
  // An operation changes before publish(), an event within it.
  if (direction == tables::Direction::operation && !tables_->comparisons.empty()) engine_.unpublished_ = true;
}

void Values::counter_changed(std::uint32_t counter, std::uint64_t count) noexcept {
  for (const std::uint32_t input : index_.of_counter.of(counter)) set_input(input, static_cast<double>(count));
  compares_all_ = true;
}

void Values::weight_changed(std::uint32_t location) noexcept {
  for (const std::uint32_t input : index_.of_weight.of(location)) set_input(input, engine_.flow_.weight(location));
  compares_all_ = true;
}

bool Values::set(std::uint32_t value, double number) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  if (!may_be_set(row.kind) || !std::isfinite(number)) return false;
  give(row.output, limited(row, number), false);
  // Also now: if this plant is saved, the one that is restored reports no changes of its past.
  const std::uint32_t trace = index_.trace_of[value];
  if (trace != tables::kNone && now() % index_.traces[trace] == 0) traces_[trace] = 1;
  states_[value].set_at = now();
  activate(value);
  return true;
}

/// Of each value in the order of the file, all entries whose condition began to hold act in order. It steps if its
/// output is then another one.
void Values::round(bool counting) noexcept {
  std::uint32_t value = tables::kNone;
  double before = 0;
  const auto close = [&] {
    if (value == tables::kNone || same(before, outputs_[tables_->rows[value].output])) return;
    activate(value);
    engine_.active_ = true;
    if (counting && states_[value].steps < kLoopSteps) ++states_[value].steps;
  };
  due_changes_.visit([&](std::uint32_t change) {
    const bool holds = engine_.truth(tables_->changes[change].condition);
    const bool begins = holds && held_[change] == 0;
    const std::uint32_t of = index_.value_of_change[change];
    if (states_[of].frozen != 0) return;
    held_[change] = holds ? 1 : 0;
    if (!begins) return;
    if (of != value) {
      close();
      value = of;
      before = outputs_[tables_->rows[of].output];
    }
    act(change);
  });
  close();
}

/// The formula reads the snapshot of the round, but its own value as it is now.
void Values::act(std::uint32_t change) noexcept {
  const std::uint32_t value = index_.value_of_change[change];
  const tables::ValueRow& row = tables_->rows[value];
  const std::uint32_t formula = tables_->changes[change].formula;
  const tables::Rows& inputs = tables_->formulas[formula].inputs;
  for (std::uint32_t i = inputs.first; i < inputs.first + inputs.count; ++i) {
    const tables::FormulaInput& input = tables_->inputs[i];
    if (input.kind == tables::FormulaInputKind::output && input.of == row.output) inputs_[i] = outputs_[row.output];
  }
  const double result = evaluate(formula);
  if (std::isfinite(result)) {
    give(row.output, limited(row, result), false);
  } else {
    set_finite(value, false);
    activate(value);  // its next computation ends the finding
  }
}

void Values::publish() noexcept {
  changed_outputs_.take_all([this](std::uint32_t output) { pass_on(output); });
  if (!compares_all_ || head_->computed == 0) return;
  compares_all_ = false;
  for (std::uint32_t c = 0; c < tables_->comparisons.size(); ++c) compare(c);
}

void Values::requeue() noexcept {
  if (!active_) return;
  for (std::uint32_t o = 0; o < tables_->outputs; ++o) changed_outputs_.mark(o);
  due_changes_.mark_all();
  compares_all_ = true;
}

double Values::operand(const tables::Operand& operand) const noexcept {
  switch (operand.kind) {
    case tables::Operand::Kind::number:
      break;
    case tables::Operand::Kind::output:
      return outputs_[operand.of];
    case tables::Operand::Kind::operation_value:
      return tables::number_of(operand.type, engine_.operation_values_.values[operand.of]);
    case tables::Operand::Kind::event_value:
      return tables::number_of(operand.type, engine_.event_values_.values[operand.of]);
    case tables::Operand::Kind::parts:
      return static_cast<double>(engine_.flow_.count(operand.of));
    case tables::Operand::Kind::weight:
      return engine_.flow_.weight(operand.of);
  }
  return operand.number;
}

void Values::compare(std::uint32_t comparison) noexcept {
  const tables::ComparisonRow& row = tables_->comparisons[comparison];
  if (head_->computed == 0) return;
  const double left = operand(row.left);
  const double right = operand(row.right);
  const bool holds = row.tolerance == 0 ? tables::compares(left, row.comparison, right)
                                        : left >= right - row.tolerance && left <= right + row.tolerance;
  if (holds == (truths_[comparison] != 0)) return;
  truths_[comparison] = holds ? 1 : 0;
  engine_.flip(row.condition, row.input);
}

void Values::forget_steps() noexcept {
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    if (states_[v].frozen == 0) states_[v].steps = 0;
  }
}

bool Values::has_loop() const noexcept {
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    if (states_[v].frozen == 0 && states_[v].steps >= kLoopSteps) return true;
  }
  return false;
}

void Values::freeze_loop(std::uint8_t loop) noexcept {
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    ValueState& state = states_[v];
    if (state.frozen != 0 || state.steps < kLoopSteps) continue;
    state.frozen = kFrozenInThisInstant;
    state.steps = loop;
    set_finite(v, true);
  }
}

void Values::close_loops() noexcept {
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    if (states_[v].frozen != 0) states_[v].frozen = kFrozenBefore;
  }
}

}  // namespace symplant::engine
