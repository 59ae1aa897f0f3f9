// PLC programs that run in lock step with a plant.
#include "symplant/program/lock_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/trace/finding_words.hpp"

namespace symplant::program {

std::string failure_words(const Failure& failure) {
  const std::string at = trace::seconds(failure.time);
  if (failure.scan < 0) return fmt::format("program `{}` did not start ({})", failure.program, at);
  return fmt::format("program `{}` failed with {} in scan {} ({})", failure.program, failure.code, failure.scan, at);
}

LockStep::LockStep(plant::Plant& plant, engine::Observer* observer)
    : plant_(plant), observer_(observer), names_(plant.tables()) {
  const auto& effects = plant.tables().malfunctions.effects;
  may_lose_ = std::any_of(effects.begin(), effects.end(),
                          [](const tables::EffectRow& effect) { return effect.kind == tables::MalfunctionKind::lose; });
}

std::string LockStep::add(const symplant_program& program, const Options& options) {
  if (std::string fault = program_fault(&program); !fault.empty()) return fault;
  const Times times = times_of(program, options);
  auto binding = std::make_unique<Binding>(bind(program, names_, options.controller, options.ignore));
  std::string errors = times.error;
  for (const std::string& error : binding->errors) errors += (errors.empty() ? "" : "\n") + error;
  if (!errors.empty()) return errors;
  Running running;
  running.instance = std::make_unique<Instance>(program, *binding, options, times, plant_);
  running.binding = std::move(binding);
  programs_.push_back(std::move(running));
  return {};
}

tables::Time LockStep::next_due() const noexcept {
  tables::Time due = tables::kNever;
  for (const Running& running : programs_) due = std::min({due, running.next, running.instance->sample()});
  return due;
}

void LockStep::fail(const Instance& instance, std::int64_t scan, int code) noexcept {
  if (!failure_) failure_ = Failure{instance.name(), scan, plant_.now(), code};
}

void LockStep::begin() noexcept {
  begun_ = true;
  crashes_.emplace();
  for (Running& running : programs_) {
    running.next = (plant_.now() + running.instance->times().period - 1) / running.instance->times().period *
                   running.instance->times().period;
    if (!running.instance->begin()) fail(*running.instance, -1, 0);
  }
}

void LockStep::end() noexcept {
  for (Running& running : programs_) running.instance->end();
  crashes_.reset();
  begun_ = false;
}

void LockStep::advance_plant(tables::Time time, bool is_end) noexcept {
  if (stepper_ == nullptr) {
    plant_.advance_to(time, observer_);
  } else {
    is_end ? stepper_->advance_to(time) : stepper_->advance_within(time);
  }
}

void LockStep::take_events() noexcept {
  if (plant_.changed_events().empty() && plant_.changed_event_values().empty()) return;
  for (Running& running : programs_) running.instance->take_events();
}

void LockStep::write_due(tables::Time time) noexcept {
  for (Running& running : programs_) {
    if (running.instance->sample() <= time) running.instance->write_operations();
  }
}

void LockStep::scan_due(tables::Time time) noexcept {
  for (Running& running : programs_) {
    if (running.next > time) continue;
    const std::int64_t scan = running.next / running.instance->times().period;
    running.next += running.instance->times().period;
    if (running.lost || failure_) continue;
    if (const int code = running.instance->scan(time); code != 0) fail(*running.instance, scan, code);
  }
}

/// Lets programs follow the loss and return of their controllers. True if operations changed.
bool LockStep::note_losses() noexcept {
  if (!any_lost_ && plant_.active_malfunctions().empty()) return false;
  bool changes = false;
  any_lost_ = false;
  for (Running& running : programs_) {
    const bool lost = plant_.is_cut(running.instance->controller());
    if (lost && !running.lost) changes = running.instance->lose() || changes;
    running.lost = lost;
    any_lost_ = any_lost_ || lost;
  }
  return changes;
}

void LockStep::advance_to(tables::Time time) noexcept {
  if (!begun_) begin();
  while (!failure_) {
    if (!shares_events_) plant_.forget_changed_events();  // they are taken
    tables::Time next = std::min(time, next_due());
    if (may_lose_) next = std::min(next, std::max(plant_.next_due(), plant_.now()));
    next = std::max(next, plant_.now());
    write_due(next);
    advance_plant(next, next >= time);
    if (!begun_) return;  // it was reset
    take_events();
    if (plant_.now() != next || frozen()) return;  // it was set back or stopped from outside
    if (note_losses()) {
      advance_plant(next, next >= time);
      take_events();
    }
    scan_due(next);
    if (next >= time) return;
  }
}

void LockStep::hold() noexcept {
  if (stepper_ != nullptr) stepper_->hold();
  if (begun_) take_events();  // what is done by hand
}

bool LockStep::restart(std::uint32_t controller) noexcept {
  bool found = false;
  for (Running& running : programs_) {
    if (running.instance->controller() != controller) continue;
    found = true;
    if (!begun_) continue;  // its start is still to come
    if (!running.instance->restart()) fail(*running.instance, -1, 0);
  }
  return found;
}

void LockStep::reset() noexcept {
  failure_.reset();
  for (Running& running : programs_) {
    running.instance->end();
    running.lost = false;
    running.next = 0;
  }
  begun_ = false;
}

}  // namespace symplant::program
