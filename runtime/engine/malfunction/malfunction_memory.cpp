// Lays out and resets the memory of malfunctions; their digest.
#include <algorithm>
#include <string_view>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/malfunction/malfunctions.hpp"

namespace symplant::engine {
namespace {

constexpr MalfunctionState kInactive{0, tables::kNever, tables::kNever, -1, {}, 0, 0, 0, 0, 0, 0, 0, {}};
constexpr EffectState kNotFlickering{tables::kNever, 0, 0, {}};

}  // namespace

// place() and place_block() set all other members.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
Malfunctions::Malfunctions(Engine& engine) noexcept
    : engine_(engine), tables_(engine.tables_), numbers_(engine.tables_), written_(tables_.malfunctions.size()) {}

void Malfunctions::place(Arena& arena) noexcept {
  auto* const names = arena.take<std::uint64_t>(written_);
  name_hashes_ = names;
  std::string_view rest = tables_.malfunctions.names;
  for (std::uint32_t m = 0; m < written_ && names != nullptr; ++m) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    names[m] = upper_case_hash(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  slow_units_.take(arena, tables_.malfunctions.units.size());
  for (const tables::EffectRow& effect : tables_.malfunctions.effects) {
    if (slow_units_.items == nullptr || effect.kind != tables::MalfunctionKind::slower) continue;
    for (const tables::MalfunctionUnit& of : tables_.malfunctions.units_of(effect)) slow_units_.add(of.unit);
  }
  if (slow_units_.items != nullptr) std::sort(slow_units_.items, slow_units_.items + slow_units_.size);
  seen_.take(arena, written_);
  most_changes_ = kMostByHand + 3 * written_;
  changes_.take(arena, most_changes_);
}

void Malfunctions::place_block(Arena& arena) noexcept {
  head_ = arena.take<Head>(1);
  states_ = arena.take<MalfunctionState>(written_);
  effects_ = arena.take<EffectState>(tables_.malfunctions.effects.size());
  holds_ = arena.take<std::uint64_t>(tables_.malfunctions.forces.size());
  active_ = arena.take<ActiveMalfunction>(written_ + tables::kMostOrdinaryMalfunctions);
  slowed_ = arena.take<std::uint64_t>((tables_.units.size() + 63) / 64);
  wholes_ = arena.take<tables::Time>(tables_.malfunctions.units.size());
}

/// The block is zero.
void Malfunctions::reset() noexcept {
  changes_.size = 0;
  seen_.clear();
  head_->window_begin = -tables::kSecond;  // the first change begins one
  for (std::uint32_t m = 0; m < written_; ++m) {
    states_[m] = kInactive;
    states_[m].due = after(m, row(m).chance, kChanceStream);
  }
  std::fill_n(effects_, tables_.malfunctions.effects.size(), kNotFlickering);
  set_next();
}

void Malfunctions::mark_all() noexcept {
  for (std::uint32_t m = 0; m < written_; ++m) seen_.mark(m);
}

void Malfunctions::hash(tables::Fnv1a64& hash) const noexcept {
  for (std::uint32_t m = 0; m < written_; ++m) {
    const MalfunctionState& state = states_[m];
    hash.byte(
        static_cast<std::uint8_t>(state.active | state.held << 1 | (state.frozen != 0 ? 4 : 0) | state.waits << 3));
    hash.time(state.since);
    hash.time(next_due(m));
    for (const std::uint32_t draws : state.draws) hash.u32(draws);
    hash_effects(m, hash);
  }
  for (const ActiveMalfunction& active : this->active()) {
    hash.u32(active.number);
    hash.time(active.since);
  }
}

/// What the flickers and held events of one remember.
void Malfunctions::hash_effects(std::uint32_t number, tables::Fnv1a64& hash) const noexcept {
  const std::span<const tables::EffectRow> effects = tables_.malfunctions.effects_of(number);
  for (std::uint32_t e = 0; e < effects.size(); ++e) {
    const EffectState& state = effect_state(number, e);
    if (effects[e].kind == tables::MalfunctionKind::flicker) {
      hash.byte(state.shows);
      hash.time(state.due);
      hash.u32(state.draws);
    }
    for (const tables::MalfunctionForce& force : tables_.malfunctions.forces_of(effects[e])) {
      if (force.holds) hash.u64(e < states_[number].begun ? value_of(force) : 0);
    }
  }
}

}  // namespace symplant::engine
