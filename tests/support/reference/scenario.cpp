// A scenario on the naive reference.
#include "support/reference/scenario.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "support/reference/round.hpp"

namespace symplant::reference {
namespace {

constexpr Time kWaits = 10 * tables::kSecond;  ///< a `wait` without `within`

Time plus(Time time, Time further) { return further > tables::kNever - 1 - time ? tables::kNever - 1 : time + further; }

bool equal(tables::DataType type, std::uint64_t a, std::uint64_t b) {
  if (type != tables::DataType::real && type != tables::DataType::lreal) return a == b;
  // 0 and -0 are one number; an expected `nan` matches `nan`.
  const auto x = std::bit_cast<double>(a);
  const auto y = std::bit_cast<double>(b);
  return x == y || (std::isnan(x) && std::isnan(y));
}

}  // namespace

/// Everything due now, with the actions done now.
void ScenarioPlayer::instant() {
  --left_;
  ends_.clear();
  plant_->advance_to(plant_->now(), &ends_);
  if (ends_.empty()) ends_.push_back(plant_->save());
}

/// Every instant before the time; the one at the time is still to run, so that steps act before its rounds.
bool ScenarioPlayer::go_to(Time time) {
  const Time target = until_ ? std::min(time, *until_) : time;
  if (target > plant_->now()) {
    instant();
    for (Time due = plant_->next_due(); due < target && !exhausted(); due = plant_->next_due()) {
      plant_->advance_before(due);
      instant();
    }
    if (exhausted()) return false;
    plant_->advance_before(target);
  }
  cut_ = time > target;
  return !cut_;
}

bool ScenarioPlayer::act(const ScenarioStep& step) {
  for (const auto& [symbol, value] : step.set) {
    if (model_->symbols[symbol].direction == tables::Direction::operation) {
      plant_->set_operation(symbol, value);
    } else {
      plant_->set_input(symbol, value);
    }
  }
  for (const auto& [name, number] : step.values) plant_->set_value(name, number);
  for (const auto& [unit, state] : step.states) plant_->set_state(unit, state);
  bool all = true;
  for (const auto& [at, kind] : step.put) all = plant_->put(at, kind) && all;
  for (const tables::PartLocation& from : step.take) all = plant_->take(from) && all;
  for (const auto& [symbol, value] : step.force) plant_->force(symbol, value);
  for (const std::uint32_t symbol : step.release) plant_->release(symbol);
  constexpr auto kBy = engine::MalfunctionChange::By::scenario;
  for (const std::uint32_t number : step.stop) plant_->stop_malfunction(number, kBy);
  for (const std::uint32_t number : step.start) all = plant_->start_malfunction(number, kBy) && all;
  return all;
}

/// At the end of one of the instants at the present time, which is the first one that the next wait looks at.
bool ScenarioPlayer::is_met(const condition::Tree& condition) {
  const auto met = std::find_if(ends_.begin(), ends_.end(), [&](const World& end) { return holds(condition, end); });
  ends_.erase(ends_.begin(), met);
  return !ends_.empty();
}

void ScenarioPlayer::wait(const ScenarioStep& step) {
  const Time start = plant_->now();
  const Time given_up = plus(start, step.time.value_or(kWaits));
  const Time last = until_ ? std::min(given_up, *until_) : given_up;
  if (ends_.empty()) instant();
  while (!is_met(*step.wait) && !exhausted()) {
    const Time due = plant_->next_due();
    if (due > last) {
      plant_->advance_to(last);
      cut_ = last < given_up;
      verdicts_.push_back({number_, false, !cut_, last, true});
      return;
    }
    plant_->advance_before(due);
    instant();
  }
  verdicts_.push_back({number_, true, true, plant_->now(), true});
}

bool ScenarioPlayer::expected(const ScenarioStep& step) const {
  const World& world = plant_->save();
  if (step.expect_condition != nullptr && !holds(*step.expect_condition, world)) return false;
  return std::all_of(step.expect.begin(), step.expect.end(), [&](const auto& each) {
    return equal(model_->symbols[each.first].type, effective(world.symbols[each.first]), each.second);
  });
}

void ScenarioPlayer::play(const ScenarioStep& step) {
  using When = ScenarioStep::When;
  const Time now = plant_->now();
  if (!cut_ && !exhausted()) {
    if (step.when == When::wait) {
      wait(step);
    } else if (go_to(step.when == When::at ? std::max(now, *step.time) : plus(now, *step.time))) {
      const bool acted = act(step);
      if (step.expects) instant();
      if (step.is_checked())
        verdicts_.push_back({number_, acted && expected(step), true, plant_->now(), step.is_expectation()});
    }
  }
  if (step.when != When::wait) ends_.clear();
  const bool reported = !verdicts_.empty() && verdicts_.back().step == number_;
  if (cut_ && !reported && step.is_checked()) {
    verdicts_.push_back({number_, false, false, until_.value_or(0), step.is_expectation()});
  }
  ++number_;
}

void ScenarioPlayer::end() {
  if (until_ && !cut_) go_to(*until_);
  instant();
}

}  // namespace symplant::reference
