// Lays out and resets the memory of values.
#include <algorithm>
#include <bit>
#include <string_view>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

using tables::ValueKind;

/// What the hash calls stored inputs: the formulas whose results a value keeps for its next step.
std::uint32_t stored_inputs(const tables::ValueRow& row) noexcept {
  return tables::makes_steps(row.kind) && row.kind != ValueKind::delay ? row.formulas : 0;
}

}  // namespace

void Values::build(Arena& arena) noexcept {
  tables_ = &engine_.tables_.values;
  active_ = !tables_->empty();
  index_.build(engine_.tables_, arena);
}

void Values::place(Arena& arena) noexcept {
  changed_outputs_.take(arena, tables_->outputs);
  unshown_ = arena.take<std::uint64_t>((tables_->outputs + 63) / 64);
  shown_.take(arena, tables_->outputs);
  ranges_ = arena.take<OutputRange>(tables_->outputs);
  off_trace_ = arena.take<std::uint8_t>(tables_->rows.size() + 1);  // one for outputs in no trace
  due_changes_.take(arena, tables_->changes.size());
  finite_changes_.take(arena, tables_->rows.size());
  numbers_ = arena.take<std::uint64_t>(tables_->signals.size());
  drifts_ = arena.take<std::uint8_t>(tables_->signals.size());
  due_groups_ = arena.take<std::uint8_t>(tables_->rows.size() + tables_->signals.size());
  passes_ = arena.take<Pass>(tables_->rows.size());
  results_ = arena.take<double>(tables::kMostLinear);
  auto* names = arena.take<std::uint64_t>(tables_->rows.size() + tables_->signals.size());
  names_ = names;
  if (names == nullptr) return;
  std::string_view rest = tables_->names;
  const auto next = [](std::string_view& texts) {
    const std::string_view text = texts.substr(0, texts.find('\0'));
    texts.remove_prefix(std::min(text.size() + 1, texts.size()));
    return text;
  };
  for (std::size_t v = 0; v < tables_->rows.size(); ++v) {
    names[v] = upper_case_hash(next(rest));
    next(rest);  // its unit
  }
  if (tables_->signals.empty()) return;
  std::string_view symbols = engine_.tables_.symbol_names;
  std::size_t signal = 0;  // sorted by symbol
  for (std::uint32_t s = 0; s < engine_.tables_.symbols.size() && signal < tables_->signals.size(); ++s) {
    const std::string_view name = next(symbols);
    next(symbols);  // its address
    if (tables_->signals[signal].symbol != s) continue;
    names[tables_->rows.size() + signal++] = upper_case_hash(name);
  }
}

void Values::place_block(Arena& arena, std::uint32_t entry) noexcept {
  entry_ = entry;
  const std::size_t owners = tables_->rows.size() + tables_->signals.size();
  head_ = arena.take<Head>(1);
  outputs_ = arena.take<double>(tables_->outputs);
  seen_ = arena.take<double>(tables_->outputs + tables_->inputs.size() + 1);
  stored_ = arena.take<double>(tables_->formulas.size());
  memory_ = arena.take<double>(index_.memory_size);
  states_ = arena.take<ValueState>(tables_->rows.size());
  signal_draws_ = arena.take<std::uint32_t>(tables_->signals.size());
  awake_count_ = arena.take<std::uint32_t>(owners);
  awake_ = arena.take<std::uint64_t>((owners + 63) / 64);
  traces_ = arena.take<std::uint8_t>((tables_->rows.size() + 8) / 8 * 8);
  held_ = arena.take<std::uint8_t>(tables_->changes.size());
  truths_ = arena.take<std::uint8_t>((tables_->comparisons.size() + 7) / 8 * 8);
}

void Values::reset() noexcept {
  if (!active_) return;
  *head_ = {-1, 0};
  changed_outputs_.clear();
  changed_ = false;
  show_all();
  due_changes_.clear();
  finite_changes_.clear();
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    const tables::ValueRow& row = tables_->rows[v];
    states_[v].set_at = -1;
    const double start = row.start_output();
    for (std::uint32_t o = 0; o < row.outputs; ++o) outputs_[row.output + o] = start;
    if (row.kind == ValueKind::delay) {
      std::fill_n(memory(v), row.steps, start);
      states_[v].equal = row.steps;
    }
    if (row.kind == ValueKind::linear) std::copy_n(&tables_->numbers[row.numbers], row.states, memory(v));
  }
  std::copy_n(outputs_, tables_->outputs, seen_);
  for (std::uint32_t i = 0; i < tables_->inputs.size(); ++i) {
    const tables::FormulaInput& input = tables_->inputs[i];
    const bool operation = input.kind == tables::FormulaInputKind::operation_value;
    if (operation || input.kind == tables::FormulaInputKind::event_value) {
      const ValuePlane& plane = operation ? engine_.operation_values_ : engine_.event_values_;
      seen_[index_.slots[i]] = tables::number_of(input.number, plane.values[input.of]);
    }
  }
  compares_others_ = true;
}

void Values::show_all() noexcept {
  const std::size_t words = (tables_->outputs + 63) / 64;
  std::fill_n(unshown_, words, ~std::uint64_t{0});
  if (tables_->outputs % 64 != 0) unshown_[words - 1] = bit_in_word(tables_->outputs) - 1;
  for (std::uint32_t o = 0; watched_ && o < tables_->outputs; ++o) widen(o);
}

void Values::show_from_here() noexcept {
  if (!active_) return;
  show_all();
  std::fill_n(traces_, index_.trace_count, std::uint8_t{1});
  set_wheel();
}

void Values::watch() noexcept {
  watched_ = true;
  for (std::uint32_t o = 0; o < tables_->outputs; ++o) ranges_[o] = {outputs_[o], outputs_[o]};
}

void Values::mark_all() noexcept {
  if (!active_) return;
  for (std::uint32_t owner = 0; owner < index_.value_count + index_.signal_count; ++owner) activate(owner);
  due_changes_.mark_all();
}

void Values::hash(tables::Fnv1a64& hash) const noexcept {
  if (!active_) return;
  const auto add = [&](double number) { hash.u64(std::bit_cast<std::uint64_t>(number)); };
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    const tables::ValueRow& row = tables_->rows[v];
    const ValueState& state = states_[v];
    for (std::uint32_t o = 0; o < row.outputs; ++o) add(outputs_[row.output + o]);
    const std::uint32_t stored = stored_inputs(row);
    if (stored != 0 || row.kind == ValueKind::delay) hash.byte(state.stored);
    for (std::uint32_t f = 0; f < stored; ++f) add(state.stored != 0 ? stored_[row.formula + f] : 0);
    if (row.kind == ValueKind::delay) {
      for (std::uint32_t i = 0; i < row.steps; ++i) add(memory(v)[(state.oldest + i) % row.steps]);
    }
    if (row.kind == ValueKind::linear) {
      for (std::uint32_t i = 0; i < row.states; ++i) add(memory(v)[i]);
    }
    if (state.held != 0) add(*memory(v));
    if (row.kind == ValueKind::pid) add(memory(v)[1]);
    if (row.kind == ValueKind::derivative || row.kind == ValueKind::pid) {
      hash.byte(state.remembers);
      add(state.remembers != 0 ? memory(v)[0] : 0);
    }
    hash.byte(state.frozen != 0 ? 1 : 0);
    hash.u32(state.draws);
  }
  for (std::uint32_t s = 0; s < tables_->signals.size(); ++s) hash.u32(signal_draws_[s]);
  for (std::uint32_t c = 0; c < tables_->changes.size(); ++c) hash.byte(held_[c]);
}

void Values::hash_not_finite(tables::Fnv1a64& hash) const noexcept {
  if (!active_) return;
  for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
    if (states_[v].not_finite == 0) continue;
    hash.byte(4);
    hash.u32(v);
  }
}

}  // namespace symplant::engine
