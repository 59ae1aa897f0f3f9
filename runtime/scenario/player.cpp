// Plays a scenario on a plant.
#include "symplant/scenario/player.hpp"

#include <algorithm>

#include "symplant/scenario/evaluate.hpp"

namespace symplant::scenario {
namespace {

constexpr std::size_t kMostLate = 256;  ///< notes that wait for one instant

/// The changes of parts and malfunctions that a step makes at most.
std::size_t hands_of(const Step& step) {
  return step.put.size() + step.take.size() + step.stop.size() + step.start.size();
}

}  // namespace

Player::Player(const Scenario& scenario, plant::Plant& plant, trace::Recorder& recorder)
    : scenario_(scenario),
      plant_(plant),
      recorder_(recorder),
      outcomes_(scenario.steps.size()),
      turns_(scenario.repeats.size()) {
  std::size_t hands = 0;
  for (const Step& step : scenario.steps) hands = std::max(hands, hands_of(step));
  late_notes_.reserve(kMostLate + hands + 2);
  std::uint32_t repeat = 0;
  for (std::uint32_t step = 0; step <= scenario.steps.size(); ++step) {
    while (repeat < scenario.repeats.size() && scenario.repeats[repeat].end < step) ++repeat;
    ends_.push_back(repeat);
  }
}

tables::Time Player::time_of(const Step& step) const noexcept {
  return step.when == Step::When::at ? std::max(step.time, moment_) : moment_ + step.time;
}

tables::Time Player::next() const noexcept {
  if (over()) return tables::kNever;
  if (waiting_) return deadline_;
  const Step& step = scenario_.steps[at_];
  return step.when == Step::When::wait ? moment_ : time_of(step);
}

void Player::instant(const engine::Instant& instant) noexcept {
  recorder_.instant(instant);
  if (!waiting_ || met_ || instant.time > deadline_) return;
  met_ = holds(*scenario_.steps[at_].expect, plant_);
  met_time_ = instant.time;
}

void Player::set(const SymbolValue& value) noexcept {
  const tables::SymbolRow& row = plant_.tables().symbols[value.symbol];
  if (row.direction() == tables::Direction::event) {
    plant_.set_input(value.symbol, value.value);
  } else if (row.type() == tables::DataType::boolean) {
    plant_.set_operation(row.index, value.value != 0);
  } else {
    plant_.set_operation_value(row.index, value.value);
  }
}

/// False if a part had no room, or there was none to take. Begins the step: if it may change more than the plant can
/// report of one instant, an instant runs before.
bool Player::act_by_hand(const Step& step) noexcept {
  const std::size_t hands = hands_of(step);
  if (late_notes_.size() > kMostLate || hands_ + hands > engine::kMostByHand) advance_plant(plant_.now());
  hands_ += hands;
  bool all = true;
  const auto failed = [&](std::uint64_t which) {
    late_notes_.push_back({kHandNote, which});
    all = false;
  };
  for (std::size_t i = 0; i < step.put.size(); ++i) {
    if (!plant_.put(step.put[i].at, step.put[i].kind)) failed(i);
  }
  for (std::size_t i = 0; i < step.take.size(); ++i) {
    if (!plant_.take(step.take[i])) failed(kTakeNote + i);
  }
  return all;
}

/// False if the step has failed already.
bool Player::act(const Step& step) noexcept {
  for (const SymbolValue& value : step.set) set(value);
  for (const UnitState& unit : step.states) plant_.set_state(unit.unit, unit.state);
  const bool well = act_by_hand(step);
  for (const SymbolValue& value : step.force) {
    plant_.force(value.symbol, value.value);
    note_force(value.symbol, true);
  }
  for (const std::uint32_t symbol : step.release) {
    plant_.release(symbol);
    note_force(symbol, false);
  }
  return change_malfunctions(step) && well;
}

/// False if too many are active.
bool Player::change_malfunctions(const Step& step) noexcept {
  using By = engine::MalfunctionChange::By;
  bool all = true;
  for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, By::scenario);
  for (std::size_t i = 0; i < step.start.size(); ++i) {
    if (plant_.start_malfunction(step.start[i], By::scenario)) continue;
    late_notes_.push_back({kHandNote, kStartNote + i});
    all = false;
  }
  return all;
}

void Player::note_force(std::uint32_t symbol, bool forced) noexcept {
  recorder_.note(plant_.now(), kForceNote, std::uint64_t{symbol} * 2 + (forced ? 1 : 0));
}

void Player::decide(Outcome::Kind kind, tables::Time time) noexcept {
  Outcome& outcome = outcomes_[at_];
  if (kind == Outcome::Kind::failed) {
    ++outcome.failed;
    const auto note = [&](std::uint32_t of, std::uint64_t value) {
      late_notes_.empty() ? static_cast<void>(recorder_.note(plant_.now(), of, value))
                          : late_notes_.push_back({of, value});
    };
    if (!scenario_.repeats.empty()) note(kTurnNote, outcome.done);
    note(static_cast<std::uint32_t>(at_), static_cast<std::uint64_t>(time));
  }
  ++outcome.done;
  if (outcome.kind != Outcome::Kind::failed) {
    outcome.kind = kind;
    outcome.time = time;
  }
  moment_ = time;
  go_on();
}

/// To the next step: that after this one, or the first one of a repeat that has more turns.
void Player::go_on() noexcept {
  ++at_;
  for (std::uint32_t r = ends_[at_]; r < turns_.size() && scenario_.repeats[r].end == at_; ++r) {
    if (++turns_[r] < scenario_.repeats[r].turns) {
      at_ = scenario_.repeats[r].begin;
      return;
    }
    turns_[r] = 0;
  }
}

/// Checks the current wait after the instant at now() has run; false while it continues.
bool Player::wait_on() noexcept {
  const Step& step = scenario_.steps[at_];
  if (!waiting_) {
    waiting_ = true;
    deadline_ = moment_ + step.time;
    met_ = holds(*step.expect, plant_);
    met_time_ = plant_.now();
  }
  if (!met_ && plant_.now() < deadline_) return false;
  waiting_ = false;
  decide(met_ ? Outcome::Kind::held : Outcome::Kind::failed, met_ ? met_time_ : deadline_);
  return true;
}

/// Runs the instants up to `time`, then adds the notes that wait for them.
void Player::advance_plant(tables::Time time) noexcept {
  plant_.advance_to(time, this);
  for (const LateNote& note : late_notes_) recorder_.note(plant_.now(), note.of, note.value);
  late_notes_.clear();
  hands_ = 0;
}

void Player::advance_to(tables::Time time) noexcept {
  plant_.advance_before(time, this);
  while (!over()) {
    const Step& step = scenario_.steps[at_];
    if (step.when == Step::When::wait) {
      advance_plant(time);
      if (!wait_on()) break;
      continue;
    }
    const tables::Time due = time_of(step);
    if (due > time) break;
    const bool well = act(step);
    if (!step.expect) {
      decide(!step.is_checked() ? Outcome::Kind::done : well ? Outcome::Kind::held : Outcome::Kind::failed, due);
      continue;
    }
    advance_plant(time);
    decide(well && holds(*step.expect, plant_) ? Outcome::Kind::held : Outcome::Kind::failed, due);
  }
  advance_plant(time);
}

void Player::end() noexcept {
  at_ = outcomes_.size();
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    Outcome& outcome = outcomes_[i];
    if (outcome.kind == Outcome::Kind::failed || outcome.done == executions(scenario_, i)) continue;
    outcome.kind = Outcome::Kind::unreached;
    outcome.time = plant_.now();
  }
}

}  // namespace symplant::scenario
