// Carries out the orders of the panel in the thread that runs the plant.
#include "symplant/panel/operate/operator.hpp"

#include <algorithm>

#include "symplant/scenario/act.hpp"

namespace symplant::panel {
namespace {

/// The most notes of an order: about itself, the instant that it begins, each force and release, and what is refused.
std::size_t notes_of(const Order& order) noexcept {
  std::size_t notes = 2;
  for (const scenario::Step& step : order.steps) {
    notes += step.force.size() + step.release.size() + step.put.size() + step.take.size() + step.start.size();
  }
  return notes;
}

std::size_t changes_by_hand(const Order& order) noexcept {
  std::size_t changes = 0;
  for (const scenario::Step& step : order.steps) changes += scenario::changes_by_hand(step);
  return changes;
}

}  // namespace

Operator::Operator(plant::Plant& plant, trace::Recorder& recorder, scenario::Player* player,
                   scenario::ProgramControl* programs, std::uint64_t seed, tables::Time cycle)
    : plant_(plant),
      recorder_(recorder),
      player_(player),
      programs_(programs),
      seed_(seed),
      cycle_(cycle),
      outputs_(plant),
      now_(plant.now()) {}

void Operator::go(Stepping stepping) noexcept {
  stepping_ = stepping;
  frozen_.store(false, std::memory_order_relaxed);
}

void Operator::stop() noexcept {
  stepping_ = Stepping::none;
  frozen_.store(true, std::memory_order_relaxed);
}

/// Does a step; `index` is that within the acts.
void Operator::act(const scenario::Step& step, std::uint64_t index) noexcept {
  using By = engine::MalfunctionChange::By;
  const auto check = [&](bool done, std::uint64_t which) {
    if (!done) recorder_.note(plant_.now(), scenario::kRefusedNote, which + (index << scenario::kRefusedBits));
  };
  scenario::write_symbols(step, plant_, programs_);
  for (std::size_t i = 0; i < step.put.size(); ++i) check(plant_.put(step.put[i].at, step.put[i].kind), i);
  for (std::size_t i = 0; i < step.take.size(); ++i) check(plant_.take(step.take[i]), scenario::kTakeNote + i);
  scenario::force_symbols(step, plant_, recorder_);
  for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, By::hand);
  for (std::size_t i = 0; i < step.start.size(); ++i) {
    check(plant_.start_malfunction(step.start[i], By::hand), scenario::kStartNote + i);
  }
}

/// Returns why it was not carried out; 0: it was.
std::uint64_t Operator::carry_out(const Order& order) noexcept {
  if (order.until != kNoLimit && order.until < act_clock()) return kTooLate;
  switch (order.kind) {
    case Order::Kind::act:
      recorder_.begin_act(plant_.now());
      for (std::size_t i = 0; i < order.steps.size(); ++i) act(order.steps[i], i);
      acted_ = true;
      return 0;
    case Order::Kind::run:
      go(Stepping::none);
      return 0;
    case Order::Kind::freeze:
      stop();
      return 0;
    case Order::Kind::step_cycle:
      go(Stepping::cycle);
      return 0;
    case Order::Kind::step_change:
      go(Stepping::change);
      return 0;
    case Order::Kind::reset:
      plant_.reset(seed_, cycle_);
      if (programs_ != nullptr) programs_->reset();
      if (player_ != nullptr) player_->begin_again();
      over_noted_ = false;
      break;
    case Order::Kind::copy: {
      const std::span<const std::byte> block = plant_.save();
      std::copy(block.begin(), block.end(), order.block.begin());
      if (order.played != nullptr) player_->save(*order.played);
      return 0;
    }
    case Order::Kind::restore:
      if (!plant_.restore(order.block)) return kDoesNotFit;
      if (player_ != nullptr && order.played != nullptr) player_->restore(*order.played);
      if (order.played == nullptr) player_ = nullptr;
      over_noted_ = false;
      break;
    case Order::Kind::play:
      player_ = order.player;
      if (player_ != nullptr) player_->control(programs_);
      if (player_ != nullptr) player_->begin_again();
      over_noted_ = false;
      return 0;
  }
  recorder_.take_over();
  jumped_ = true;
  return 0;
}

void Operator::take_orders() noexcept {
  while (orders_.read_available() != 0) {
    const Order order = orders_.front();
    if (!recorder_.has_room(notes_of(order))) return;  // the next cycle has room again
    const std::size_t changes = changes_by_hand(order);
    if (changes_ != 0 && changes_ + changes > engine::kMostByHand) return;
    changes_ += changes;
    orders_.pop();
    const std::uint64_t outcome = carry_out(order);
    recorder_.note(plant_.now(), kOrderNote,
                   order.id + outcome + (std::uint64_t{recorder_.turn()} << scenario::kTurnBits));
  }
}

void Operator::advance(tables::Time time) noexcept {
  begun_ = true;
  jumped_ = acted_ = false;
  changes_ = 0;
  if (player_ != nullptr) {
    player_->advance_to(time);
    if (!over_noted_ && player_->over()) over_noted_ = recorder_.note(plant_.now(), kOverNote, 0);
  } else {
    plant_.advance_to(time, &recorder_);
    recorder_.next_turn();
  }
  now_.store(plant_.now(), std::memory_order_relaxed);
  outputs_.give(plant_);
}

void Operator::advance_to(tables::Time time) noexcept {
  advance_within(time);
  if (stepping_ == Stepping::cycle) stop();
}

void Operator::advance_within(tables::Time time) noexcept {
  const std::uint64_t before = recorder_.instants();
  plant_.advance_before(time, observer());
  take_orders();
  advance(jumped_ ? plant_.now() : time);
  if (stepping_ == Stepping::change && recorder_.instants() != before) stop();
}

void Operator::hold() noexcept {
  take_orders();
  if (begun_ && (acted_ || jumped_)) advance(plant_.now());
  outputs_.give(plant_);
}

}  // namespace symplant::panel
