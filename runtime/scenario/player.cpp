// Plays a scenario on a plant.
#include "symplant/scenario/player.hpp"

#include <algorithm>

#include "symplant/scenario/evaluate.hpp"

namespace symplant::scenario {
namespace {

constexpr std::size_t kMostLate = 256;  ///< notes that wait for one instant

}  // namespace

Player::Player(const Scenario& scenario, plant::Plant& plant, trace::Recorder& recorder)
    : scenario_(scenario),
      plant_(plant),
      recorder_(recorder),
      outcomes_(scenario.steps.size()),
      turns_(scenario.repeats.size()) {
  std::size_t hands = 0;
  for (const Step& step : scenario.steps) hands = std::max(hands, changes_by_hand(step));
  late_notes_.reserve(kMostLate + hands + 2);
  std::uint32_t repeat = 0;
  for (std::uint32_t step = 0; step <= scenario.steps.size(); ++step) {
    while (repeat < scenario.repeats.size() && scenario.repeats[repeat].end < step) ++repeat;
    ends_.push_back(repeat);
  }
}

tables::Time Player::time_of(const Step& step) const noexcept {
  return step.when == Step::When::at ? std::max(step.time, position_.moment) : position_.moment + step.time;
}

tables::Time Player::next() const noexcept {
  if (over()) return tables::kNever;
  if (position_.waiting) return position_.deadline;
  const Step& step = scenario_.steps[position_.at];
  return step.when == Step::When::wait ? position_.moment : time_of(step);
}

void Player::instant(const engine::Instant& instant) noexcept {
  recorder_.instant(instant);
  end_met_waits(instant.time);
}

/// Something of a step was refused, by the value of a kHandNote.
void Player::refuse(std::uint64_t which) noexcept {
  if (notes_steps_) recorder_.note(plant_.now(), kRefusedNote, which);
  if (notes_failures_) late_notes_.push_back({kHandNote, which});
}

/// Begins a step: if it may change more than the plant can report of one instant, an instant runs before.
void Player::make_room(const Step& step) noexcept {
  const std::size_t hands = changes_by_hand(step);
  if (late_notes_.size() > kMostLate || hands_ + hands > engine::kMostByHand) advance_plant(plant_.now());
  hands_ += hands;
}

/// False if a part had no room, or there was none to take.
bool Player::act_by_hand(const Step& step) noexcept {
  bool all = true;
  const auto failed = [&](std::uint64_t which) {
    refuse(which);
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
  make_room(step);
  turn_ = recorder_.turn();
  if (needs_act(step, plant_.tables())) {
    recorder_.begin_act(plant_.now());
    recorder_.act(plant_.now(), trace::kActNote, position_.at);
  }
  write_symbols(step, plant_, programs_);
  const bool well = act_by_hand(step);
  force_symbols(step, plant_, recorder_);
  return change_malfunctions(step) && well;
}

/// False if too many are active.
bool Player::change_malfunctions(const Step& step) noexcept {
  using By = engine::MalfunctionChange::By;
  bool all = true;
  for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, By::scenario);
  for (std::size_t i = 0; i < step.start.size(); ++i) {
    if (plant_.start_malfunction(step.start[i], By::scenario)) continue;
    refuse(kStartNote + i);
    all = false;
  }
  return all;
}

void Player::decide(Outcome::Kind kind, tables::Time time) noexcept {
  Outcome& outcome = outcomes_[position_.at];
  if (kind == Outcome::Kind::failed) ++outcome.failed;
  if (kind == Outcome::Kind::failed && notes_failures_) {
    const auto note = [&](std::uint32_t of, std::uint64_t value) {
      late_notes_.empty() ? static_cast<void>(recorder_.note(plant_.now(), of, value))
                          : late_notes_.push_back({of, value});
    };
    if (!scenario_.repeats.empty()) note(kTurnNote, outcome.done);
    note(static_cast<std::uint32_t>(position_.at), static_cast<std::uint64_t>(time));
  }
  if (notes_steps_) {
    recorder_.note(
        plant_.now(), kStepNote,
        position_.at + (kind == Outcome::Kind::failed ? kStepFailed : 0) + (std::uint64_t{turn_} << kTurnBits));
  }
  ++outcome.done;
  if (outcome.kind != Outcome::Kind::failed) {
    outcome.kind = kind;
    outcome.time = time;
  }
  position_.moment = time;
  go_on();
}

/// To the next step: that after this one, or the first one of a repeat that has more turns.
void Player::go_on() noexcept {
  ++position_.at;
  for (std::uint32_t r = ends_[position_.at]; r < turns_.size() && scenario_.repeats[r].end == position_.at; ++r) {
    if (++turns_[r] < scenario_.repeats[r].turns) {
      position_.at = scenario_.repeats[r].begin;
      return;
    }
    turns_[r] = 0;
  }
}

/// Runs the instants up to `time`, then adds the notes that wait for them.
void Player::advance_plant(tables::Time time) noexcept {
  plant_.advance_to(time, this);
  recorder_.next_turn();
  for (const LateNote& note : late_notes_) recorder_.note(plant_.now(), note.of, note.value);
  late_notes_.clear();
  hands_ = 0;
}

void Player::begin_wait() noexcept {
  position_.waiting = true;
  position_.deadline = position_.moment + scenario_.steps[position_.at].time;
}

/// At the end of an instant: ends the current wait if its condition holds, and then each wait that follows it. The
/// instants in which a wait begins count even if its time has passed.
void Player::end_met_waits(tables::Time time) noexcept {
  while (position_.waiting && (wait_begins_ || time <= position_.deadline)) {
    if (!holds(*scenario_.steps[position_.at].expect, plant_)) return;
    position_.waiting = false;
    decide(Outcome::Kind::held, time);
    if (!over() && scenario_.steps[position_.at].when == Step::When::wait) begin_wait();
  }
}

/// The current step is a wait: runs the instants up to `time`; false if a wait continues after them.
bool Player::wait_until(tables::Time time) noexcept {
  wait_begins_ = !position_.waiting;
  if (wait_begins_) begin_wait();
  advance_plant(time);
  end_met_waits(time);  // a condition that held before is not part of an instant with a change
  wait_begins_ = false;
  if (!position_.waiting) return true;
  if (time < position_.deadline) return false;
  position_.waiting = false;
  decide(Outcome::Kind::failed, position_.deadline);
  return true;
}

void Player::advance_to(tables::Time time) noexcept {
  plant_.advance_before(time, this);
  while (!over()) {
    const Step& step = scenario_.steps[position_.at];
    if (step.when == Step::When::wait) {
      if (!wait_until(time)) break;
      continue;
    }
    const tables::Time due = time_of(step);
    if (due > time) break;
    const bool well = act(step);
    if (!step.expect) {
      if (step.ends_instant) advance_plant(time);
      decide(!step.is_checked() ? Outcome::Kind::done : well ? Outcome::Kind::held : Outcome::Kind::failed, due);
      continue;
    }
    advance_plant(time);
    decide(well && holds(*step.expect, plant_) ? Outcome::Kind::held : Outcome::Kind::failed, due);
  }
  advance_plant(time);
}

void Player::begin_again() noexcept {
  std::fill(outcomes_.begin(), outcomes_.end(), Outcome{});
  std::fill(turns_.begin(), turns_.end(), 0);
  late_notes_.clear();
  hands_ = 0;
  position_ = {.moment = plant_.now()};
}

void Player::save(State& state) const noexcept {
  state.position = position_;
  std::copy(turns_.begin(), turns_.end(), state.turns.begin());
  std::copy(outcomes_.begin(), outcomes_.end(), state.outcomes.begin());
}

void Player::restore(const State& state) noexcept {
  position_ = state.position;
  std::copy(state.turns.begin(), state.turns.end(), turns_.begin());
  std::copy(state.outcomes.begin(), state.outcomes.end(), outcomes_.begin());
  late_notes_.clear();
  hands_ = 0;
}

void Player::end() noexcept {
  position_.at = outcomes_.size();
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    Outcome& outcome = outcomes_[i];
    if (outcome.kind == Outcome::Kind::failed || outcome.done == executions(scenario_, i)) continue;
    outcome.kind = Outcome::Kind::unreached;
    outcome.time = plant_.now();
  }
}

}  // namespace symplant::scenario
