// Makes the look-ups of values.
#include "symplant/engine/value/value_index.hpp"

#include <algorithm>

#include "symplant/engine/bit_words.hpp"

namespace symplant::engine {
namespace {

using tables::FormulaInputKind;
using tables::ValueKind;

/// Numbers that a value remembers besides its output and stored inputs.
std::uint32_t memory_of(const tables::ValueRow& row) noexcept {
  switch (row.kind) {
    case ValueKind::delay:
      return row.steps;
    case ValueKind::parameter:
    case ValueKind::derivative:
      return 1;
    case ValueKind::pid:
      return 2;
    case ValueKind::linear:
      return row.states;
    default:
      return 0;
  }
}

std::uint8_t as_number(ValueKind kind) noexcept { return static_cast<std::uint8_t>(kind); }

bool reads_more(const tables::Operand& operand) noexcept {
  return operand.kind != tables::Operand::Kind::number && operand.kind != tables::Operand::Kind::output;
}

/// Groups `reader` numbers by the source that `source_of(reader)` says; kNone: it reads none.
template <class SourceOf>
void group(Readers& readers, std::uint32_t sources, std::uint32_t count, Arena& arena, SourceOf source_of) noexcept {
  readers.begins = arena.take<std::uint32_t>(sources + std::size_t{1});
  readers.readers = arena.take<std::uint32_t>(count);
  if (readers.begins == nullptr) return;
  for (std::uint32_t r = 0; r < count; ++r) {
    const std::uint32_t source = source_of(r);
    if (source != tables::kNone) ++readers.begins[source + 1];
  }
  for (std::uint32_t s = 0; s < sources; ++s) readers.begins[s + 1] += readers.begins[s];
  for (std::uint32_t r = count; r-- > 0;) {  // from the end, so that each begin moves to its place
    const std::uint32_t source = source_of(r);
    if (source != tables::kNone) readers.readers[--readers.begins[source + 1]] = r;
  }
  for (std::uint32_t s = 0; s < sources; ++s) readers.begins[s] = readers.begins[s + 1];
  std::uint32_t total = 0;
  for (std::uint32_t r = 0; r < count; ++r) total += source_of(r) != tables::kNone ? 1U : 0U;
  readers.begins[sources] = total;
}

}  // namespace

void ValueIndex::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  const tables::ValueTables& values = tables.values;
  value_count = static_cast<std::uint32_t>(values.rows.size());
  signal_count = static_cast<std::uint32_t>(values.signals.size());
  const std::uint32_t owners = value_count + signal_count;
  const auto input_count = static_cast<std::uint32_t>(values.inputs.size());
  steps = arena.take<tables::Time>(owners);
  traces = arena.take<tables::Time>(value_count);
  uses = arena.take<OutputUse>(values.outputs);
  group_at = arena.take<std::uint32_t>(owners);
  rank_of = arena.take<std::uint32_t>(owners);
  step_at = arena.take<ValueStep>(value_count);
  rank_of_input = arena.take<std::uint32_t>(input_count);
  slots = arena.take<std::uint32_t>(input_count);
  formula_steps = values.compiled.empty() ? arena.take<tables::FormulaStep>(values.steps.size()) : nullptr;
  value_of_change = arena.take<std::uint32_t>(values.changes.size());
  memory = arena.take<std::uint32_t>(value_count);
  timed_signals = arena.take<std::uint8_t>(signal_count);
  for (RankSet* const set : {&stepping, &computed, &signals}) {
    *set = {arena.take<std::uint64_t>((owners + 63) / 64), 0, 0};
  }
  memory_size = 0;
  for (std::uint32_t v = 0; v < value_count; ++v) {
    if (memory != nullptr) memory[v] = memory_size;
    memory_size += memory_of(values.rows[v]);
  }
  const auto inputs_of = [&](FormulaInputKind kind) {
    return [&values, kind](std::uint32_t i) {
      return values.inputs[i].kind == kind ? values.inputs[i].of : tables::kNone;
    };
  };
  group(of_operation_value, tables.operation_slots, input_count, arena, inputs_of(FormulaInputKind::operation_value));
  group(of_event_value, tables.event_slots, input_count, arena, inputs_of(FormulaInputKind::event_value));
  group(of_counter, static_cast<std::uint32_t>(tables.material.counters.size()), input_count, arena,
        inputs_of(FormulaInputKind::parts));
  group(of_weight, tables.material.locations(), input_count, arena, inputs_of(FormulaInputKind::weight));
  const auto comparison_count = static_cast<std::uint32_t>(values.comparisons.size());
  // Each comparison twice: its left and its right operand.
  group(comparisons_of_output, values.outputs, 2 * comparison_count, arena, [&values](std::uint32_t r) {
    const tables::ComparisonRow& row = values.comparisons[r / 2];
    const tables::Operand& operand = r % 2 == 0 ? row.left : row.right;
    return operand.kind == tables::Operand::Kind::output ? operand.of : tables::kNone;
  });
  others = arena.take<std::uint32_t>(comparison_count);
  other_count = 0;
  for (std::uint32_t c = 0; others != nullptr && c < comparison_count; ++c) {
    if (reads_more(values.comparisons[c].left) || reads_more(values.comparisons[c].right)) others[other_count++] = c;
  }
  if (group_at != nullptr) {
    rank_all(values);
    find_inputs(values);
  }
  Readers of_output;
  group(of_output, values.outputs, input_count, arena, [&](std::uint32_t i) {
    const bool wakes = values.inputs[i].kind == FormulaInputKind::output && rank_of_input[i] != tables::kNone;
    return wakes ? values.inputs[i].of : tables::kNone;
  });
  output_readers = of_output.readers;
  for (std::uint32_t o = 0; group_at != nullptr && o < values.outputs; ++o) {
    uses[o].readers = of_output.begins[o];
    uses[o].readers_end = of_output.begins[o + 1];
    for (std::uint32_t r = uses[o].readers; r < uses[o].readers_end; ++r) {
      output_readers[r] = rank_of_input[output_readers[r]];
    }
    uses[o].others = !comparisons_of_output.of(o).empty() || !tables.material.drives.empty();
  }
}

/// The order of computation, and the groups of equal steps.
void ValueIndex::rank_all(const tables::ValueTables& values) noexcept {
  group_count = trace_count = 0;
  /// The number of a time among different ones; kNone for 0.
  const auto number_of = [](tables::Time time, tables::Time* times, std::uint32_t& count) {
    if (time == 0) return tables::kNone;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (times[i] == time) return i;
    }
    times[count] = time;
    return count++;
  };
  std::uint32_t rank = 0;
  const auto rank_next = [&](std::uint32_t owner, tables::Time step, RankSet& set) {
    rank_of[owner] = rank;
    group_at[rank] = number_of(step, steps, group_count);
    set.add(rank);
    ++rank;
  };
  const auto rank_value = [&](std::uint32_t v, RankSet& set) {
    const tables::ValueRow& row = values.rows[v];
    step_at[rank] = {
        static_cast<double>(row.step) / 1e9,      row.min,  row.max, row.factor, v, row.output, row.formula,
        static_cast<std::uint16_t>(row.formulas), row.kind, false};
    if (row.kind == ValueKind::linear) stepping.add(rank);
    rank_next(v, row.step, set);
  };
  for (auto kind = ValueKind::parameter; kind <= ValueKind::delay; kind = static_cast<ValueKind>(as_number(kind) + 1)) {
    for (std::uint32_t v = 0; v < value_count; ++v) {
      if (values.rows[v].kind == kind) rank_value(v, stepping);
    }
  }
  for (const std::uint32_t v : values.order) rank_value(v, computed);
  for (std::uint32_t s = 0; s < signal_count; ++s) rank_next(value_count + s, values.signals[s].every, signals);
  for (std::uint32_t v = 0; v < value_count; ++v) {
    const tables::ValueRow& row = values.rows[v];
    const std::uint32_t trace = number_of(row.trace, traces, trace_count);
    for (std::uint32_t o = 0; o < row.outputs; ++o) uses[row.output + o].trace = trace;
    for (std::uint32_t c = 0; c < row.changes.count; ++c) value_of_change[row.changes.first + c] = v;
  }
  for (std::uint32_t o = 0; o < values.outputs; ++o) uses[o].trace = std::min(uses[o].trace, trace_count);
}

/// Where formulas see what they read, and what must be computed if that changes.
void ValueIndex::find_inputs(const tables::ValueTables& values) noexcept {
  const auto input_count = static_cast<std::uint32_t>(values.inputs.size());
  time_slot = values.outputs + input_count;
  reads_time = false;
  for (std::uint32_t i = 0; i < input_count; ++i) {
    const tables::FormulaInput& input = values.inputs[i];
    const bool time = input.kind == FormulaInputKind::time;
    slots[i] = input.kind == FormulaInputKind::output ? input.of : time ? time_slot : values.outputs + i;
    reads_time = reads_time || time;
    rank_of_input[i] = tables::kNone;
  }
  const auto own = [&](std::uint32_t rank, std::uint32_t formula) {
    const tables::Rows& inputs = values.formulas[formula].inputs;
    bool timed = false;
    for (std::uint32_t i = inputs.first; i < inputs.first + inputs.count; ++i) {
      rank_of_input[i] = rank;
      timed = timed || slots[i] == time_slot;
    }
    return timed;
  };
  for (std::uint32_t rank = 0; rank < value_count; ++rank) {
    ValueStep& step = step_at[rank];
    for (std::uint32_t f = 0; f < step.formulas; ++f) step.timed = own(rank, step.formula + f) || step.timed;
  }
  for (std::uint32_t s = 0; s < signal_count; ++s) {
    timed_signals[s] = own(value_count + s, values.signals[s].formula) ? 1 : 0;
  }
  for (const tables::FormulaRow& row : values.formulas) {
    for (std::uint32_t i = row.steps.first; formula_steps != nullptr && i < row.steps.first + row.steps.count; ++i) {
      formula_steps[i] = values.steps[i];
      if (values.steps[i].op == tables::FormulaOp::input) {
        formula_steps[i].of = slots[row.inputs.first + values.steps[i].of];
      }
    }
  }
}

}  // namespace symplant::engine
