// Lays out and resets the engine's memory.
#include <algorithm>
#include <new>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

constexpr std::uint64_t kMagic = 0x7379'6D70'6C61'6E0B;  // "symplan" and the version of the block's layout

bool draws(const tables::PlantTables& tables) noexcept {
  if (tables.random_times.size() + tables.behaviour_units.size() != 0) return true;
  return std::any_of(tables.types.begin(), tables.types.end(), [](const tables::TypeRow& type) {
    return std::any_of(type.transitions.begin(), type.transitions.end(),
                       [](const tables::Transition& t) { return t.numbers.weight != 0; });
  });
}

}  // namespace

void ValuePlane::take(Arena& arena, std::size_t slots) noexcept {
  made = arena.take<std::uint64_t>(slots);
  values = arena.take<std::uint64_t>(slots);
  forced = arena.take<std::uint64_t>((slots + 63) / 64);
  forced_to = arena.take<std::uint64_t>(slots);
  broken = arena.take<std::uint64_t>((slots + 63) / 64);
  dirty.take(arena, slots);
}

void BitPlane::take(Arena& arena, std::size_t words) noexcept {
  made_ = arena.take<std::uint64_t>(words);
  bits = arena.take<std::uint64_t>(words);
  forced = arena.take<std::uint64_t>(words);
  forced_on = arena.take<std::uint64_t>(words);
  opposite = arena.take<std::uint64_t>(words);
  broken = arena.take<std::uint64_t>(words);
  dirty.take(arena, words);
}

Engine* Engine::make(const tables::PlantTables& tables, std::span<const Behaviour> behaviours, Arena& arena) noexcept {
  auto* raw = arena.take<std::max_align_t>((sizeof(Engine) + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t));
  if (raw == nullptr) {
    Engine counting(tables, behaviours);
    counting.position(arena);
    return nullptr;
  }
  auto* engine = new (raw) Engine(tables, behaviours);
  engine->position(arena);
  engine->head_->magic = kMagic;
  engine->head_->model = tables::model_hash(tables);
  engine->head_->size = engine->block_size_;
  return engine;
}

void Engine::position(Arena& arena) noexcept {
  const std::size_t event_words = tables_.event_bits / 64;
  index_.build(tables_, arena);
  position_names(arena);
  flow_.build(arena);
  malfunctions_.place(arena);
  values_.build(arena);
  place_block(arena);

  operation_plane_ = {operations_.bits, index_.inverted_operations, tables_.operation_bits / 64};
  event_plane_ = {events_.bits, index_.inverted_events, event_words};
  event_changes_.take(arena, event_words);
  changed_event_slots_.take(arena, tables_.event_slots);
  pulses_.take(arena, event_words);
  on_request_ = arena.take<std::uint64_t>(event_words);
  findings_.take(arena);
  queue_ = arena.take<std::uint32_t>(tables_.units.size());
  queued_ = 0;
  round_ = 0;
  touched_.take(arena, tables_.units.size());
  moved_.take(arena, index_.general.size());
  counted_.take(arena, index_.general.size());
  waiting_.take(arena, tables_.conditions.size());
  touched_requirements_.take(arena, tables_.requirements.size());
  due_follows_.take(arena, tables_.follows.size());
  flow_.place(arena);
  values_.place(arena);
  blocked_.take(arena, tables_.material.transfers.size());
  overrun_.take(arena, tables_.overruns.size());
  violated_.take(arena, tables_.requirements.size());
  short_events_.take(arena, event_words);
  touched_slots_.take(arena, tables_.event_slots);
  values_before_ = arena.take<std::uint64_t>(tables_.event_slots);
  operation_changes_.take(arena, tables_.operation_bits / 64);
  operation_slot_changes_.take(arena, tables_.operation_slots);
  event_slot_changes_.take(arena, tables_.event_slots);
  const std::size_t loop_members = tables::first_value_of_loop(tables_) + tables_.values.rows.size();
  marks_.take(arena, std::max({loop_members, tables_.symbols.size(), tables_.requirements.size()}));
  suspects_ = 0;
  loops_ = 0;
  active_ = false;
  reported_any_ = false;
  first_ = false;
  closes_more_ =
      index_.some_inverted || !index_.overruns.empty() || flow_.active() || values_.active() || malfunctions_.written();
  unpublished_ = true;
  now_ = 0;
  observer_ = nullptr;
}

/// Hashes the names of general units for random numbers, and computes the offset of each behavior's memory.
void Engine::position_names(Arena& arena) noexcept {
  auto* hashes = arena.take<std::uint64_t>(index_.general.size());
  auto* begins = arena.take<std::uint64_t>(tables_.behaviour_units.size() + 1);
  name_hashes_ = hashes;
  memory_begins_ = begins;
  if (begins != nullptr) {
    for (std::size_t b = 0; b < tables_.behaviour_units.size(); ++b) begins[b + 1] = begins[b] + memory_of(b);
  }
  if (hashes == nullptr || !draws(tables_)) return;
  std::string_view names = tables_.unit_names;
  for (std::uint32_t unit = 0; unit < tables_.units.size() && !names.empty(); ++unit) {
    const std::size_t end = names.find('\0');
    if (tables_.units[unit].general != 0)
      hashes[index_.general.position_of(unit)] = upper_case_hash(names.substr(0, end));
    names.remove_prefix(end == names.npos ? names.size() : end + 1);
  }
}

std::uint32_t Engine::memory_of(std::size_t behaviour) const noexcept {
  const std::uint32_t name = tables_.behaviour_units[behaviour].name;
  return name < behaviours_.size() ? (behaviours_[name].memory_size + 7) / 8 * 8 : 0;
}

void Engine::place_block(Arena& arena) noexcept {
  // One word more, always 0: units without operations read it.
  const std::size_t operation_word_count = tables_.operation_bits / 64 + 1;
  const std::size_t entries =
      tables_.units.size() + tables_.requirements.size() + tables_.behaviour_units.size() + tables_.overruns.size();
  const std::size_t all_entries = entries + flow_.wheel_entries() + values_.wheel_entries();
  head_ = arena.take<BlockHead>(1);
  const std::size_t begin = arena.used() - sizeof(BlockHead);
  units_ = arena.take<UnitState>(all_entries);
  operations_.take(arena, operation_word_count);
  events_.take(arena, tables_.event_bits / 64);
  operation_values_.take(arena, tables_.operation_slots);
  event_values_.take(arena, tables_.event_slots);
  written_values_ = arena.take<std::uint64_t>(tables_.operation_slots);
  written_words_.take(arena, operation_word_count);
  written_slots_.take(arena, tables_.operation_slots);
  disarmed_ = arena.take<std::uint64_t>(operation_word_count);
  operation_words_ = arena.take<OperationWord>(operation_word_count);
  general_states_ = arena.take<GeneralState>(index_.general.size());
  records_ = arena.take<Record>(index_.general.records());
  condition_states_ = arena.take<std::uint8_t>(tables_.conditions.size());
  monitors_ = arena.take<MonitorState>(tables_.requirements.size());
  behaviour_states_ = arena.take<BehaviourState>(tables_.behaviour_units.size());
  follow_states_ = arena.take<FollowState>(tables_.follows.size());
  overrun_states_ = arena.take<OverrunState>(tables_.overruns.size());
  overrun_begins_ = arena.take<tables::Time>(index_.overruns.operations());
  flow_.place_block(arena, static_cast<std::uint32_t>(entries));
  malfunctions_.place_block(arena);
  values_.place_block(arena, static_cast<std::uint32_t>(entries + flow_.wheel_entries()));
  std::size_t memory = 0;
  for (std::size_t b = 0; b < tables_.behaviour_units.size(); ++b) memory += memory_of(b);
  behaviour_memory_ = reinterpret_cast<std::byte*>(arena.take<std::uint64_t>(memory / 8));
  recent_rises_.take(arena, tables_.event_bits / 64);
  block_size_ = arena.used() - begin;
}

void Engine::reset(std::uint64_t seed, tables::Time cycle) noexcept {
  const BlockHead kept = *head_;
  std::fill_n(reinterpret_cast<std::byte*>(head_), block_size_, std::byte{0});
  head_->magic = kept.magic;
  head_->model = kept.model;
  head_->size = kept.size;
  head_->seed = seed;
  head_->cycle = cycle;
  cycle_end_ = -1;
  head_->waits = kNotStarted | (malfunctions_.written() ? kMayChange : 0U);
  head_->wheel.clear();
  touched_.size = moved_.size = 0;
  findings_.clear();
  reset_levels();
  reset_values();
  for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) {
    const tables::UnitRow& row = tables_.units[unit];
    units_[unit].state = units_[unit].target = static_cast<std::uint8_t>(row.initial);
    units_[unit].transition = kNoTransition;
    if (row.general != 0 || !index_.types[row.type].plain) units_[unit].flags = kGeneral;
    if (row.general != 0 && behaviour_of(general_row(unit)) != nullptr) units_[unit].flags |= kBehaves;
    switch_events(row, index_.types[row.type].at[row.initial].enter);
  }
  for (std::uint32_t position = 0; position < index_.general.size(); ++position) {
    general_states_[position].position = tables::kNoState;
    moved_.add(index_.general.rows()[position].unit);
    units_[index_.general.rows()[position].unit].flags |= kDriven;
  }
  for (std::size_t b = 0; b < tables_.behaviour_units.size(); ++b) behaviour_states_[b].wake = tables::kNever;
  values_.reset();
  reset_conditions();
  flow_.reset();
  malfunctions_.reset();
  event_changes_.note_all(tables_.event_bits / 64);
  for (std::uint32_t slot = 0; slot < tables_.event_slots; ++slot) changed_event_slots_.mark(slot);
  start_behaviours();
}

/// Writes inverted operations as on: their units see them off. Of symbols on one address the leader decides: one that
/// is not inverted as its leader is starts as if on.
void Engine::reset_levels() noexcept {
  if (!index_.some_inverted) return;
  for (std::uint32_t word = 0; word < tables_.operation_bits / 64; ++word) {
    operation_words_[word].written = index_.inverted_operations[word];
  }
  for (const tables::SharedAddress& shared : tables_.shared_addresses) {
    const tables::SymbolRow& symbol = tables_.symbols[shared.symbol];
    if (symbol.type() != tables::DataType::boolean) continue;
    if (symbol.inverted() == tables_.symbols[shared.leader].inverted()) continue;
    const std::uint32_t word = symbol.index / 64;
    const bool operation = symbol.direction() == tables::Direction::operation;
    (operation ? operations_ : events_).bits[word] |= bit_in_word(symbol.index);
    if (operation) operation_words_[word].written ^= bit_in_word(symbol.index);
  }
}

/// Sets numeric symbols to their initial values; BOOL events that no unit sets switch on in the first instant.
void Engine::reset_values() noexcept {
  for (const tables::InitialValue& initial : tables_.initial_values) {
    const tables::SymbolRow& symbol = tables_.symbols[initial.symbol];
    const bool operation = symbol.direction() == tables::Direction::operation;
    const SharedPositions& shared = operation ? index_.shared_operations : index_.shared_events;
    if (symbol.type() == tables::DataType::boolean) {
      if (!operation) make_event_bits(symbol.index / 64, bit_in_word(symbol.index), 0);
      continue;
    }
    ValuePlane& plane = operation ? operation_values_ : event_values_;
    const auto set = [&](std::uint32_t slot) {
      plane.made[slot] = plane.values[slot] = initial.value;
      if (operation) written_values_[slot] = initial.value;
    };
    set(symbol.index);
    for (const SharedPosition& other : shared.with(kSharedSlot + symbol.index)) set(other.position - kSharedSlot);
  }
}

/// Evaluates all conditions with all units' operations and events off, no unit settled, and the initial numbers.
void Engine::reset_conditions() noexcept {
  const auto start = [&](std::span<const tables::ValueWatch> watches, const ValuePlane& plane) {
    for (const tables::ValueWatch& watch : watches) {
      if (tables::holds(watch, plane.values[watch.slot])) flip(watch.condition, watch.input);
    }
  };
  waiting_.size = 0;
  const auto start_bits = [&](std::span<const tables::BitWatch> watches, const BitPlane& plane,
                              const std::uint64_t* inverted) {
    for (const tables::BitWatch& watch : watches) {
      if (((plane.bits[watch.bit / 64] ^ inverted[watch.bit / 64]) & bit_in_word(watch.bit)) != 0) {
        flip(watch.condition, watch.input);
      }
    }
  };
  if (index_.some_inverted) {
    start_bits(tables_.operation_watches, operations_, index_.inverted_operations);
    start_bits(tables_.event_watches, events_, index_.inverted_events);
  }
  start(tables_.operation_value_watches, operation_values_);
  start(tables_.event_value_watches, event_values_);
  for (const tables::ValueWatch& watch : tables_.part_watches) {
    if (tables::holds(watch, 0)) flip(watch.condition, watch.input);
  }
  for (std::uint32_t condition = 0; condition < tables_.conditions.size(); ++condition) {
    std::uint8_t& state = condition_states_[condition];
    if ((state & kWaiting) != 0) continue;
    state |= kWaiting;
    waiting_.add(condition);
  }
  settle_conditions();
  touched_requirements_.clear();
  unpublished_ = true;
  see_events();
}

}  // namespace symplant::engine
