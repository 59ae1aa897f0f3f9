// Jumps of values, and what the engine passes to values and what values pass on.
#include <cmath>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/formula.hpp"

namespace symplant::engine {

void Values::set_input(std::uint32_t input, double number) noexcept {
  double& seen = seen_[index_.slots[input]];
  if (same(seen, number)) return;
  seen = number;
  const std::uint32_t rank = index_.rank_of_input[input];
  if (rank != tables::kNone && !is_awake(rank)) wake(rank);
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
  compares_others_ = true;
  // An operation changes before publish(), an event within it.
  if (direction == tables::Direction::operation && !tables_->comparisons.empty()) engine_.unpublished_ = true;
}

void Values::counter_changed(std::uint32_t counter, std::uint64_t count) noexcept {
  for (const std::uint32_t input : index_.of_counter.of(counter)) set_input(input, static_cast<double>(count));
  compares_others_ = true;
}

void Values::weight_changed(std::uint32_t location) noexcept {
  for (const std::uint32_t input : index_.of_weight.of(location)) set_input(input, engine_.flow_.weight(location));
  compares_others_ = true;
}

bool Values::set(std::uint32_t value, double number) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  if (!tables::keeps_its_output(row.kind) || !std::isfinite(number)) return false;
  if (states_[value].held == 0) give_by_hand(value, limited(number, row.min, row.max));
  if (states_[value].held != 0) *memory(value) = limited(number, row.min, row.max);
  states_[value].set_at = now();
  activate(value);
  return true;
}

/// Between two instants.
void Values::give_by_hand(std::uint32_t value, double number) noexcept {
  const std::uint32_t output = tables_->rows[value].output;
  give_later(output, number);
  // Also now: if this plant is saved, the one that is restored reports no changes of its past.
  const std::uint32_t trace = index_.uses[output].trace;
  if (trace != index_.trace_count && now() % index_.traces[trace] == 0) traces_[trace] = 1;
}

void Values::hold(std::uint32_t value, const double* number) noexcept {
  const tables::ValueRow& row = tables_->rows[value];
  ValueState& state = states_[value];
  if (state.held == 0) *memory(value) = outputs_[row.output];
  give_by_hand(value, number != nullptr ? limited(*number, row.min, row.max) : *memory(value));
  state.held = number != nullptr ? 1 : 0;
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
  const double before = seen_[row.output];
  seen_[row.output] = outputs_[row.output];
  const double result = evaluate(formula);
  seen_[row.output] = before;
  if (std::isfinite(result)) {
    jump(value, limited(result, row.min, row.max));
  } else {
    set_finite(value, false);
    activate(value);  // its next computation ends the finding; a parameter has none
  }
}

/// A jump; of a parameter that a malfunction holds it is seen when that ends.
void Values::jump(std::uint32_t value, double number) noexcept {
  if (states_[value].held != 0) {
    *memory(value) = number;
  } else {
    give_later(tables_->rows[value].output, number);
  }
}

void Values::publish() noexcept {
  pass_on_later();
  if (!compares_others_ || head_->computed == 0) return;
  compares_others_ = false;
  for (const std::uint32_t c : index_.other_comparisons()) compare(c);
}

void Values::requeue() noexcept {
  if (!active_) return;
  for (std::uint32_t o = 0; o < tables_->outputs; ++o) changed_outputs_.mark(o);
  due_changes_.mark_all();
  compares_others_ = true;
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
  const bool holds = tables::compares_near(operand(row.left), row.comparison, operand(row.right), row.tolerance);
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
    if (is_awake(index_.rank_of[v])) sleep(index_.rank_of[v]);
  }
}

void Values::close_loops() noexcept {
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    if (states_[v].frozen != 0) states_[v].frozen = kFrozenBefore;
  }
}

}  // namespace symplant::engine
