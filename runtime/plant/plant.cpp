// Implements Plant on the engine.
#include "symplant/plant/plant.hpp"

#include <algorithm>
#include <exception>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/engine.hpp"

namespace symplant::plant {
std::size_t Plant::memory_size(const tables::PlantTables& tables,
                               std::span<const engine::Behaviour> behaviours) noexcept {
  engine::Arena counting(nullptr);
  engine::Engine::make(tables, behaviours, counting);
  return counting.used();
}

Plant::Plant(const tables::PlantTables& tables, std::span<std::byte> memory,
             std::span<const engine::Behaviour> behaviours) noexcept
    : tables_(tables) {
  if (memory.size() < memory_size(tables, behaviours)) std::terminate();
  engine::Arena arena(memory.data());
  engine_ = engine::Engine::make(tables, behaviours, arena);
  reset();
}

std::uint64_t Plant::model_hash() const noexcept { return engine_->model_hash(); }

void Plant::reset(std::uint64_t seed, tables::Time cycle) noexcept { engine_->reset(seed, cycle); }

void Plant::set_operation(std::uint32_t bit, bool on) noexcept { engine_->write_operation(bit, on); }

void Plant::set_operations(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept {
  engine_->write_operations(word, mask, bits);
}

void Plant::set_operation_value(std::uint32_t slot, std::uint64_t value) noexcept {
  engine_->write_operation_value(slot, value);
}

bool Plant::set_input(std::uint32_t symbol, std::uint64_t value) noexcept { return engine_->set_input(symbol, value); }

void Plant::force(std::uint32_t symbol, std::uint64_t value) noexcept { engine_->force(symbol, true, value); }

void Plant::release(std::uint32_t symbol) noexcept { engine_->force(symbol, false, 0); }

bool Plant::is_forced(std::uint32_t symbol) const noexcept { return engine_->is_forced(symbol); }

void Plant::set_state(std::uint32_t unit, std::uint8_t state) noexcept {
  if (state < tables_.types[tables_.units[unit].type].states) engine_->set_state(unit, state);
}

void Plant::set_quality(bool well) noexcept {
  for (std::size_t b = 0; b < tables_.behaviour_units.size(); ++b) engine_->set_quality(b, well);
}

void Plant::set_quality(std::uint32_t behaviour, bool well) noexcept { engine_->set_quality(behaviour, well); }

void Plant::show(engine::Observer* observer) noexcept { engine_->show(observer); }

void Plant::advance_to(tables::Time time, engine::Observer* observer) noexcept { engine_->advance_to(time, observer); }

void Plant::advance_before(tables::Time time, engine::Observer* observer) noexcept {
  engine_->advance_before(time, observer);
}

tables::Time Plant::now() const noexcept { return engine_->now(); }

tables::Time Plant::next_due() const noexcept { return engine_->next_due(); }

bool Plant::operation(std::uint32_t bit) const noexcept {
  return (engine_->operations()[bit / 64] >> (bit % 64) & 1) != 0;
}

bool Plant::event(std::uint32_t bit) const noexcept { return (engine_->events()[bit / 64] >> (bit % 64) & 1) != 0; }

std::uint64_t Plant::operation_value(std::uint32_t slot) const noexcept { return engine_->operation_value(slot); }
std::uint64_t Plant::written_operation_value(std::uint32_t slot) const noexcept {
  return engine_->written_operation_value(slot);
}

std::uint64_t Plant::event_value(std::uint32_t slot) const noexcept { return engine_->event_value(slot); }

engine::BitWords Plant::operations() const noexcept { return engine_->operations(); }

engine::BitWords Plant::events() const noexcept { return engine_->events(); }

std::span<const std::uint32_t> Plant::changed_events() const noexcept {
  return engine_->changed_events().since_forgotten();
}

std::span<const std::uint32_t> Plant::changed_event_values() const noexcept {
  return engine_->changed_event_values().list.view();
}

std::uint64_t Plant::pulsed_events(std::uint32_t word) const noexcept { return engine_->pulsed_events(word); }

void Plant::forget_changed_events() noexcept { engine_->forget_changed_events(); }

void Plant::show_on_request(std::span<const std::uint64_t> events) noexcept { engine_->show_on_request(events); }

UnitView Plant::unit(std::uint32_t unit) const noexcept {
  const engine::UnitState& state = engine_->unit(unit);
  const auto is = [&](std::uint16_t flag) { return (state.flags & flag) != 0; };
  UnitView view{
      state.state, state.state, is(engine::kMoving), is(engine::kMidway), is(engine::kDisabled), is(engine::kFrozen), 0,
      0,           0.0};
  if (!view.moving) return view;
  view.target = state.target;
  view.remaining = std::max<tables::Time>(engine_->remaining(unit), 0);
  view.whole = engine_->whole(unit);
  view.progress = view.whole == 0
                      ? 1.0
                      : std::max(0.0, 1.0 - static_cast<double>(view.remaining) / static_cast<double>(view.whole));
  return view;
}

tables::Time Plant::after_left(std::uint32_t unit, std::uint16_t transition) const noexcept {
  return engine_->after_left(unit, transition);
}

std::span<const std::uint64_t> Plant::disarmed() const noexcept { return engine_->disarmed(); }

bool Plant::put(tables::PartLocation to, std::uint32_t kind) noexcept { return engine_->put(to, kind); }

bool Plant::take(tables::PartLocation from) noexcept { return engine_->take(from); }

std::uint32_t Plant::parts(std::uint32_t location) const noexcept { return engine_->flow().parts(location); }

PartView Plant::part(std::uint32_t location, std::uint32_t index) const noexcept {
  const engine::Flow& flow = engine_->flow();
  if (tables_.material.is_track(location)) {
    const engine::Part& part = flow.part_on(location, index);
    return {part.number, part.kind, part.at(engine_->now()) / engine::kMicrometer, part.v, part.drive, part.since};
  }
  const engine::PlacePart& part = flow.part_in(tables_.material.place_of(location), index);
  return {part.number, part.kind, 0, 0, 0, part.since};
}

PartMotion Plant::motion(std::uint32_t track, std::uint32_t index) const noexcept {
  const engine::Part& part = engine_->flow().part_on(track, index);
  return {part.at(engine_->now()) / engine::kMicrometer, part.v};
}

std::uint64_t Plant::parts_made(std::uint32_t kind) const noexcept { return engine_->flow().kind(kind).made; }

std::uint64_t Plant::parts_gone(std::uint32_t kind) const noexcept { return engine_->flow().kind(kind).gone; }

std::uint64_t Plant::parts_present(std::uint32_t kind) const noexcept {
  std::uint64_t count = 0;
  for (std::uint32_t location = 0; location < tables_.material.locations(); ++location) {
    for (std::uint32_t i = 0; i < parts(location); ++i) count += part(location, i).kind == kind ? 1U : 0U;
  }
  return count;
}

bool Plant::is_frozen_track(std::uint32_t track) const noexcept { return engine_->flow().is_frozen_track(track); }

TransferView Plant::transfer(std::uint32_t transfer) const noexcept {
  const engine::Flow& flow = engine_->flow();
  const tables::TransferRow& row = tables_.material.transfers[transfer];
  const engine::TransferState& state = flow.transfer(transfer);
  TransferView view{state.blocked != 0, state.frozen != 0, row.once && state.permission == 0, 0, 0};
  const engine::Candidate found = flow.candidate(row.from);
  if (found.index == tables::kNone) return view;
  view.part = part(row.from.location, found.index).number;
  view.obstacle = flow.obstacle(row, found);
  return view;
}

SourceView Plant::source(std::uint32_t source) const noexcept {
  const engine::SourceState& state = engine_->flow().source(source);
  return {state.due, state.made};
}

bool Plant::set_value(std::uint32_t value, double number) noexcept { return engine_->set_value(value, number); }

double Plant::output(std::uint32_t output) const noexcept { return engine_->values().output(output); }

void Plant::show_outputs() noexcept { engine_->show_outputs(); }

void Plant::watch_outputs() noexcept { engine_->watch_outputs(); }

engine::OutputRange Plant::output_range(std::uint32_t output) const noexcept { return engine_->values().range(output); }

double Plant::weight(std::uint32_t location) const noexcept { return engine_->flow().weight(location); }

bool Plant::start_malfunction(std::uint32_t number, engine::MalfunctionChange::By by) noexcept {
  return engine_->start_malfunction(number, by);
}

bool Plant::stop_malfunction(std::uint32_t number, engine::MalfunctionChange::By by) noexcept {
  return engine_->stop_malfunction(number, by);
}

MalfunctionView Plant::malfunction(std::uint32_t number) const noexcept {
  const engine::Malfunctions& malfunctions = engine_->malfunctions();
  const engine::ActiveMalfunction* active = malfunctions.find(number);
  return {active != nullptr, active != nullptr ? active->since : 0, malfunctions.next_due(number)};
}

std::span<const engine::ActiveMalfunction> Plant::active_malfunctions() const noexcept {
  return engine_->malfunctions().active();
}

bool Plant::is_stuck(std::uint32_t unit) const noexcept { return engine_->malfunctions().is_stuck(unit); }

std::uint32_t Plant::malfunction_of_symbol(std::uint32_t symbol) const noexcept {
  return engine_->malfunctions().of_symbol(symbol);
}

bool Plant::is_cut(std::uint32_t controller) const noexcept { return engine_->malfunctions().is_cut(controller); }

bool Plant::is_pending(std::uint32_t requirement) const noexcept { return engine_->is_pending(requirement); }

bool Plant::take_finding(tables::Finding& finding) noexcept { return engine_->take_finding(finding); }

std::uint64_t Plant::lost_findings() const noexcept { return engine_->lost_findings(); }

std::span<const std::byte> Plant::save() const noexcept { return engine_->save(); }

bool Plant::restore(std::span<const std::byte> block) noexcept { return engine_->restore(block); }

std::uint64_t Plant::state_hash() const noexcept { return engine_->state_hash(); }

}  // namespace symplant::plant
