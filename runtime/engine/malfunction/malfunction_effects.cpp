// What malfunctions do: slow and stop units, override symbols.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/malfunction/malfunctions.hpp"
#include "symplant/engine/wide.hpp"

namespace symplant::engine {
namespace {

using tables::MalfunctionKind;

/// `time` times a factor in thousandths, rounded down. A time that never comes stays so.
tables::Time times(tables::Time time, std::uint32_t factor) noexcept {
  if (time == tables::kNever) return time;
  const Wide product = static_cast<Wide>(time) * factor / 1000;
  return product > static_cast<Wide>(tables::kNever) ? tables::kNever : static_cast<tables::Time>(product);
}

}  // namespace

/// Calls `function(unit, state)` for each unit that the malfunction slows or stops.
template <class Function>
void Malfunctions::for_units(std::uint32_t number, Function function) const noexcept {
  if (numbers_.is_written(number)) {
    for (const tables::MalfunctionUnit& of : numbers_.units_of(number)) function(of.unit, of.state);
  } else if (numbers_.is_of_unit(number)) {
    function(numbers_.unit(number), tables::kNoState);
  }
}

/// Calls `function(symbol, value)` for each symbol to which the malfunction gives a value.
template <class Function>
void Malfunctions::for_values(std::uint32_t number, Function function) const noexcept {
  if (numbers_.kind(number) != MalfunctionKind::force) return;
  if (numbers_.is_written(number)) {
    const tables::Rows rows = row(number).of;
    for (const tables::MalfunctionForce& force : tables_.malfunctions.forces.subspan(rows.first, rows.count)) {
      function(force.symbol, force.value);
    }
  } else {
    function(numbers_.symbol(number), numbers_.is_on(number) ? 1 : 0);
  }
}

void Malfunctions::affect(std::uint32_t number) noexcept {
  const MalfunctionKind kind = numbers_.kind(number);
  for_units(number, [&](std::uint32_t unit, std::uint8_t state) {
    kind == MalfunctionKind::stuck ? stick(unit, state) : slow(unit);
  });
  for_values(number, [this](std::uint32_t symbol, std::uint64_t) { override_again(symbol); });
}

void Malfunctions::release(std::uint32_t number) noexcept {
  const MalfunctionKind kind = numbers_.kind(number);
  if (kind == MalfunctionKind::stuck) {
    for_units(number, [this](std::uint32_t unit, std::uint8_t) { unstick(unit); });
  }
  for_values(number, [this](std::uint32_t symbol, std::uint64_t) { override_again(symbol); });
  if (kind == MalfunctionKind::flicker) override_again(row(number).subject);
}

bool Malfunctions::is_stuck(std::uint32_t unit) const noexcept {
  return std::any_of(active().begin(), active().end(), [&](const ActiveMalfunction& a) {
    return numbers_.kind(a.number) == MalfunctionKind::stuck && numbers_.names_unit(a.number, unit);
  });
}

bool Malfunctions::is_cut(std::uint32_t controller) const noexcept {
  return std::any_of(active().begin(), active().end(), [&](const ActiveMalfunction& a) {
    return numbers_.kind(a.number) == MalfunctionKind::lose && row(a.number).subject == controller;
  });
}

void Malfunctions::stick(std::uint32_t unit, std::uint8_t state) noexcept {
  if (state != tables::kNoState) engine_.set_state(unit, state);
  if (tables_.units[unit].general != 0) ++engine_.general_state(unit).disabled_by;
  if ((engine_.units_[unit].flags & kDisabled) == 0) engine_.disable(unit);
  engine_.touch(unit);
}

/// A unit that nothing else disables is enabled at once: this is not reported as by the end of a `disables`.
void Malfunctions::unstick(std::uint32_t unit) noexcept {
  const bool disabled =
      tables_.units[unit].general != 0 ? --engine_.general_state(unit).disabled_by != 0 : is_stuck(unit);
  if (!disabled) engine_.enable(unit, 0);
  engine_.touch(unit);
}

/// The unit leaves the fast path, and its moves ask slowed() for their times.
void Malfunctions::slow(std::uint32_t unit) noexcept { engine_.units_[unit].flags |= kSlowed | kGeneral; }

tables::Time Malfunctions::slowed(std::uint32_t unit, const tables::UnitRow& unit_row, tables::Time time) noexcept {
  bool any = false;
  const auto slow_by = [&](std::uint32_t factor) {
    time = times(time, factor);
    any = true;
  };
  for (std::uint32_t m = 0; m < written_; ++m) {
    if (states_[m].active == 0 || row(m).kind != MalfunctionKind::slower || !numbers_.names_unit(m, unit)) continue;
    slow_by(row(m).factor);
  }
  if (find(numbers_.slow(unit)) != nullptr) slow_by(tables::kOrdinarySlower);
  const bool general = unit_row.general != 0;
  if (!general) set_whole(unit, time, any);
  if (any) return time;
  std::uint16_t& flags = engine_.units_[unit].flags;
  flags &= static_cast<std::uint16_t>(~kSlowed);
  if (!general && engine_.index_.types[unit_row.type].plain) flags &= static_cast<std::uint16_t>(~kGeneral);
  return time;
}

/// The place for the total time of a unit's move; null if only the ordinary malfunction slows it.
tables::Time* Malfunctions::place_of_whole(std::uint32_t unit) const noexcept {
  const auto units = slow_units_.view();
  const auto found = std::lower_bound(units.begin(), units.end(), unit);
  return found == units.end() || *found != unit ? nullptr : wholes_ + (found - units.begin());
}

void Malfunctions::set_whole(std::uint32_t unit, tables::Time time, bool slower) noexcept {
  set_bit(slowed_[unit / 64], unit, slower);
  tables::Time* const place = place_of_whole(unit);
  if (slower && place != nullptr) *place = time;
}

tables::Time Malfunctions::whole(std::uint32_t unit, tables::Time time) const noexcept {
  if ((slowed_[unit / 64] & bit_in_word(unit)) == 0) return time;
  const tables::Time* const place = place_of_whole(unit);
  return place == nullptr ? times(time, tables::kOrdinarySlower) : *place;
}

/// Equal for symbols of one address.
std::uint64_t Malfunctions::address_of(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  const std::uint32_t position = (row.type() == tables::DataType::boolean ? 0 : kSharedSlot) + row.index;
  const SharedPositions& shared = operation ? engine_.index_.shared_operations : engine_.index_.shared_events;
  const auto others = shared.empty() ? std::span<const SharedPosition>() : shared.with(position);
  return (std::uint64_t{operation} << 32) | (others.empty() ? position : others.front().leader);
}

std::uint32_t Malfunctions::of_symbol(std::uint32_t symbol) const noexcept {
  const std::uint64_t address = address_of(symbol);
  std::uint32_t found = tables::kNone;
  for (const ActiveMalfunction& a : active()) {
    const auto look = [&](std::uint32_t other, std::uint64_t) {
      if (address_of(other) == address) found = a.number;
    };
    for_values(a.number, look);
    if (numbers_.kind(a.number) == MalfunctionKind::flicker) look(row(a.number).subject, 0);
  }
  return found;
}

/// What all active ones together do to a symbol: one after the other, as they started.
Override Malfunctions::override_of(std::uint32_t symbol) const noexcept {
  const std::uint64_t address = address_of(symbol);
  Override to{Override::Kind::none, true, 0};
  for (const ActiveMalfunction& a : active()) {
    for_values(a.number, [&](std::uint32_t other, std::uint64_t value) {
      if (address_of(other) == address) to = {Override::Kind::value, true, value};
    });
    const bool flickers = numbers_.kind(a.number) == MalfunctionKind::flicker && states_[a.number].shows != 0;
    if (!flickers || address_of(row(a.number).subject) != address) continue;
    if (to.kind == Override::Kind::value) {
      to.value ^= 1;
    } else {
      to.kind = to.kind == Override::Kind::none ? Override::Kind::opposite : Override::Kind::none;
    }
  }
  return to;
}

void Malfunctions::override_again(std::uint32_t symbol) noexcept {
  if (!engine_.is_forced(symbol)) engine_.override_symbol(symbol, override_of(symbol));
}

}  // namespace symplant::engine
