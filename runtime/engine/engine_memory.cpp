// Lays out and resets the engine's memory.
#include <algorithm>
#include <new>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

constexpr std::uint64_t kMagic = 0x7379'6D70'6C61'6E03;  // "symplan" and the version of the block's layout

/// fnv1a64 of a unit's name in the upper case of ASCII.
std::uint64_t hash_of_name(std::string_view name) noexcept {
  tables::Fnv1a64 hash;
  for (const char c : name) hash.byte(static_cast<std::uint8_t>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c));
  return hash.value();
}

}  // namespace

void ValuePlane::take(Arena& arena, std::size_t slots) noexcept {
  made = arena.take<std::uint64_t>(slots);
  values = arena.take<std::uint64_t>(slots);
  forced = arena.take<std::uint64_t>((slots + 63) / 64);
  forced_to = arena.take<std::uint64_t>(slots);
  dirty.take(arena, slots);
}

void BitPlane::take(Arena& arena, std::size_t words) noexcept {
  made_ = arena.take<std::uint64_t>(words);
  bits = arena.take<std::uint64_t>(words);
  forced = arena.take<std::uint64_t>(words);
  forced_on = arena.take<std::uint64_t>(words);
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
  engine->head->magic = kMagic;
  engine->head->model = tables::model_hash(tables);
  engine->head->size = engine->block_size;
  return engine;
}

void Engine::position(Arena& arena) noexcept {
  const std::size_t event_words = tables.event_bits / 64;
  index.build(tables, arena);
  position_names(arena);
  place_block(arena);

  event_changes.take(arena, event_words);
  changed_event_slots.take(arena, tables.event_slots);
  findings.take(arena);
  queue_ = arena.take<std::uint32_t>(tables.units.size());
  queued_ = 0;
  round_ = 0;
  touched_.take(arena, tables.units.size());
  moved_.take(arena, index.general.size());
  counted_.take(arena, index.general.size());
  waiting_.take(arena, tables.conditions.size());
  touched_requirements_.take(arena, tables.requirements.size());
  violated_.take(arena, tables.requirements.size());
  short_events_.take(arena, event_words);
  touched_slots_.take(arena, tables.event_slots);
  values_before_ = arena.take<std::uint64_t>(tables.event_slots);
  operation_changes_.take(arena, tables.operation_bits / 64);
  operation_slot_changes_.take(arena, tables.operation_slots);
  event_slot_changes_.take(arena, tables.event_slots);
  marks_.take(arena, std::max({tables.units.size(), tables.symbols.size(), tables.requirements.size()}));
  suspects_ = 0;
  loops_ = 0;
  active_ = false;
  reported_any_ = false;
  unpublished_ = true;
  now_ = 0;
  observer_ = nullptr;
}

/// Hashes the names of general units for random numbers, and computes the offset of each behavior's memory.
void Engine::position_names(Arena& arena) noexcept {
  auto* hashes = arena.take<std::uint64_t>(index.general.size());
  auto* begins = arena.take<std::uint64_t>(tables.behaviour_units.size() + 1);
  name_hashes_ = hashes;
  memory_begins_ = begins;
  if (begins != nullptr) {
    for (std::size_t b = 0; b < tables.behaviour_units.size(); ++b) begins[b + 1] = begins[b] + memory_of(b);
  }
  if (hashes == nullptr || tables.random_times.size() + tables.behaviour_units.size() == 0) return;
  std::string_view names = tables.unit_names;
  for (std::uint32_t unit = 0; unit < tables.units.size() && !names.empty(); ++unit) {
    const std::size_t end = names.find('\0');
    if (tables.units[unit].general != 0) hashes[index.general.position_of(unit)] = hash_of_name(names.substr(0, end));
    names.remove_prefix(end == names.npos ? names.size() : end + 1);
  }
}

std::uint32_t Engine::memory_of(std::size_t behaviour) const noexcept {
  const std::uint32_t name = tables.behaviour_units[behaviour].name;
  return name < behaviours.size() ? (behaviours[name].memory_size + 7) / 8 * 8 : 0;
}

void Engine::place_block(Arena& arena) noexcept {
  // One word more, always 0: units without operations read it.
  const std::size_t operation_word_count = tables.operation_bits / 64 + 1;
  const std::size_t entries = tables.units.size() + tables.requirements.size() + tables.behaviour_units.size();
  head = arena.take<BlockHead>(1);
  const std::size_t begin = arena.used() - sizeof(BlockHead);
  units = arena.take<UnitState>(entries);
  operations.take(arena, operation_word_count);
  events.take(arena, tables.event_bits / 64);
  operation_values.take(arena, tables.operation_slots);
  event_values.take(arena, tables.event_slots);
  written_values = arena.take<std::uint64_t>(tables.operation_slots);
  written_words.take(arena, operation_word_count);
  written_slots.take(arena, tables.operation_slots);
  disarmed = arena.take<std::uint64_t>(operation_word_count);
  operation_words = arena.take<OperationWord>(operation_word_count);
  general_states = arena.take<GeneralState>(index.general.size());
  records = arena.take<Record>(index.general.records());
  condition_states = arena.take<std::uint8_t>(tables.conditions.size());
  monitors = arena.take<MonitorState>(tables.requirements.size());
  behaviour_states = arena.take<BehaviourState>(tables.behaviour_units.size());
  std::size_t memory = 0;
  for (std::size_t b = 0; b < tables.behaviour_units.size(); ++b) memory += memory_of(b);
  behaviour_memory = reinterpret_cast<std::byte*>(arena.take<std::uint64_t>(memory / 8));
  short_events.take(arena, tables.event_bits / 64);
  block_size = arena.used() - begin;
}

void Engine::reset(std::uint64_t seed, tables::Time cycle) noexcept {
  const BlockHead kept = *head;
  std::fill_n(reinterpret_cast<std::byte*>(head), block_size, std::byte{0});
  head->magic = kept.magic;
  head->model = kept.model;
  head->size = kept.size;
  head->seed = seed;
  head->cycle = cycle;
  head->wheel.clear();
  touched_.size = moved_.size = 0;
  findings.clear();
  reset_values();
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    const tables::UnitRow& row = tables.units[unit];
    units[unit].state = units[unit].target = static_cast<std::uint8_t>(row.initial);
    units[unit].transition = kNoTransition;
    if (row.general != 0 || !index.types[row.type].plain) units[unit].flags = kGeneral;
    if (row.general != 0 && behaviour_of(general_row(unit)) != nullptr) units[unit].flags |= kBehaves;
    switch_events(row, index.types[row.type].at[row.initial].enter);
  }
  for (std::uint32_t position = 0; position < index.general.size(); ++position) {
    general_states[position].settled = tables::kNoState;
    moved_.add(index.general.rows()[position].unit);
    units[index.general.rows()[position].unit].flags |= kDriven;
  }
  for (std::size_t b = 0; b < tables.behaviour_units.size(); ++b) behaviour_states[b].wake = tables::kNever;
  reset_conditions();
  event_changes.note_all(tables.event_bits / 64);
  for (std::uint32_t slot = 0; slot < tables.event_slots; ++slot) changed_event_slots.mark(slot);
}

/// Sets numeric symbols to their initial values; BOOL events that no unit sets switch on in the first instant.
void Engine::reset_values() noexcept {
  for (const tables::InitialValue& initial : tables.initial_values) {
    const tables::SymbolRow& symbol = tables.symbols[initial.symbol];
    const bool operation = symbol.direction() == tables::Direction::operation;
    const SharedPositions& shared = operation ? index.shared_operations : index.shared_events;
    if (symbol.type() == tables::DataType::boolean) {
      if (!operation) make_event_bits(symbol.index / 64, bit_in_word(symbol.index), 0);
      continue;
    }
    ValuePlane& plane = operation ? operation_values : event_values;
    const auto set = [&](std::uint32_t slot) {
      plane.made[slot] = plane.values[slot] = initial.value;
      if (operation) written_values[slot] = initial.value;
    };
    set(symbol.index);
    for (const SharedPosition& other : shared.with(kSharedSlot + symbol.index)) set(other.position - kSharedSlot);
  }
}

/// Evaluates all conditions with all bits off, no unit settled, and the initial numbers.
void Engine::reset_conditions() noexcept {
  const auto start = [&](std::span<const tables::ValueWatch> watches, const ValuePlane& plane) {
    for (const tables::ValueWatch& watch : watches) {
      if (tables::holds(watch, plane.values[watch.slot])) flip(watch.condition, watch.input);
    }
  };
  waiting_.size = 0;
  start(tables.operation_value_watches, operation_values);
  start(tables.event_value_watches, event_values);
  for (std::uint32_t condition = 0; condition < tables.conditions.size(); ++condition) {
    std::uint8_t& state = condition_states[condition];
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
