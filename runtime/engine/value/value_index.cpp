// Makes the look-ups of values.
#include "symplant/engine/value/value_index.hpp"

namespace symplant::engine {
namespace {

using tables::FormulaInputKind;
using tables::ValueKind;

bool steps_first(ValueKind kind) noexcept {
  return kind == ValueKind::parameter || kind == ValueKind::integral || kind == ValueKind::lag ||
         kind == ValueKind::ramp || kind == ValueKind::delay;
}

/// Numbers that a value remembers besides its output and stored inputs.
std::uint32_t memory_of(const tables::ValueRow& row) noexcept {
  switch (row.kind) {
    case ValueKind::delay:
      return row.steps;
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
  trace_of = arena.take<std::uint32_t>(value_count);
  group_of = arena.take<std::uint32_t>(owners);
  rank_of = arena.take<std::uint32_t>(owners);
  owner_at = arena.take<std::uint32_t>(owners);
  owner_of_input = arena.take<std::uint32_t>(input_count);
  value_of_output = arena.take<std::uint32_t>(values.outputs);
  value_of_change = arena.take<std::uint32_t>(values.changes.size());
  memory = arena.take<std::uint32_t>(value_count);
  timed = arena.take<std::uint8_t>(owners);
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
  group(of_output, values.outputs, input_count, arena, inputs_of(FormulaInputKind::output));
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
  if (group_of == nullptr || owners == 0) return;

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
  const auto group_with = [&](tables::Time step) { return number_of(step, steps, group_count); };
  std::uint32_t rank = 0;
  const auto rank_next = [&](std::uint32_t owner) {
    rank_of[owner] = rank;
    owner_at[rank++] = owner;
  };
  for (std::uint32_t v = 0; v < value_count; ++v) {
    if (steps_first(values.rows[v].kind)) rank_next(v);
  }
  for (const std::uint32_t v : values.order) rank_next(v);
  for (std::uint32_t s = 0; s < signal_count; ++s) rank_next(value_count + s);
  for (std::uint32_t v = 0; v < value_count; ++v) {
    const tables::ValueRow& row = values.rows[v];
    group_of[v] = group_with(row.step);
    trace_of[v] = number_of(row.trace, traces, trace_count);
    for (std::uint32_t o = 0; o < row.outputs; ++o) value_of_output[row.output + o] = v;
    for (std::uint32_t c = 0; c < row.changes.count; ++c) value_of_change[row.changes.first + c] = v;
  }
  for (std::uint32_t s = 0; s < signal_count; ++s) group_of[value_count + s] = group_with(values.signals[s].every);
  for (std::uint32_t i = 0; i < input_count; ++i) owner_of_input[i] = tables::kNone;
  const auto own = [&](std::uint32_t owner, std::uint32_t formula) {
    const tables::Rows& inputs = values.formulas[formula].inputs;
    for (std::uint32_t i = inputs.first; i < inputs.first + inputs.count; ++i) {
      owner_of_input[i] = owner;
      if (values.inputs[i].kind == FormulaInputKind::time) timed[owner] = 1;
    }
  };
  for (std::uint32_t v = 0; v < value_count; ++v) {
    for (std::uint32_t f = 0; f < values.rows[v].formulas; ++f) own(v, values.rows[v].formula + f);
  }
  for (std::uint32_t s = 0; s < signal_count; ++s) own(value_count + s, values.signals[s].formula);
}

}  // namespace symplant::engine
