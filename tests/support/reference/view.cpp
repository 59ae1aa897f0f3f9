// What a behavior sees and does.
#include "support/reference/round.hpp"

namespace symplant::reference {

tables::Time View::now() const noexcept { return round_.next.time; }
std::uint8_t View::state() const noexcept { return round_.next.units[unit_].state; }
std::uint8_t View::target() const noexcept { return round_.next.units[unit_].target; }
bool View::moving() const noexcept { return round_.next.units[unit_].moving; }

// Its own arming is current, as are all other values of the unit.
bool View::operation(std::uint8_t operation) const noexcept {
  const std::uint32_t symbol = round_.of(unit_).operations[operation];
  return is_on(round_.rules, round_.old, symbol) && round_.next.units[unit_].operations[operation].armed;
}

bool View::event(std::uint8_t event) const noexcept {
  const std::uint32_t symbol = round_.of(unit_).events[event];
  return round_.rules.turned(symbol, round_.next.symbols[symbol].value) != 0;
}

bool View::input(std::uint32_t input) const noexcept {
  const UnitRules& rules = round_.of(unit_);
  return holds(*rules.conditions[rules.first_input + input], round_.old);
}

std::uint64_t View::value(std::uint32_t value) const noexcept {
  const std::uint32_t symbol = round_.of(unit_).values[value];
  if (round_.rules.is_operation(symbol)) return effective(round_.old.symbols[symbol]);
  return round_.next.symbols[symbol].value;
}

bool View::quality() const noexcept { return round_.next.link_well; }

void View::set_event(std::uint8_t event, bool on) noexcept {
  write_event(round_.rules, round_.next, round_.of(unit_).events[event], on ? 1 : 0);
}

void View::set_value(std::uint32_t value, std::uint64_t bits) noexcept {
  const std::uint32_t symbol = round_.of(unit_).values[value];
  if (!round_.rules.is_operation(symbol)) write_event(round_.rules, round_.next, symbol, bits);
}

void View::wake_at(tables::Time time) noexcept {
  const Time left = time <= now() ? 0 : time - now();
  round_.next.units[unit_].until_woken = time == tables::kNever ? -1 : left;
}

std::uint64_t View::draw() noexcept {
  ++round_.counters[Counted::draw_behaviour];
  return first_output(round_.next.seed, round_.of(unit_).path, 0xFFFF, round_.next.units[unit_].own_draws++);
}

void* View::memory_bytes() noexcept { return round_.next.units[unit_].memory.data(); }

}  // namespace symplant::reference
