// Draws scenarios step by step and plays them on the reference, so that most of their expectations hold.
#include "property/files/random_scenario.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "property/files/plan_of_model.hpp"
#include "property/files/random_hands.hpp"
#include "property/files/random_starts.hpp"
#include "property/files/resolved_steps.hpp"
#include "property/files/shared_symbols.hpp"
#include "property/random_malfunctions.hpp"
#include "property/random_material.hpp"
#include "property/random_plant.hpp"
#include "property/random_unit.hpp"
#include "support/reference/round.hpp"

namespace symplant::property::files {
namespace {

using When = Step::When;
using tables::kMillisecond;

class ScenarioDrawer {
 public:
  ScenarioDrawer(Dice& dice, std::uint64_t seed, const model::PlantModel& plant)
      : dice_(dice),
        plant_(plant),
        plan_(plan_of(plant)),
        resolver_(plant),
        reference_(plant),
        player_(plant, reference_, std::nullopt, most_instants(plant)),
        fails_(dice.percent(55) ? 12 : 0) {
    reference_.reset(seed);
    for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
      if (plant.symbols[i].direction == tables::Direction::operation) {
        operations_.push_back(i);
        continue;
      }
      if (may_be_driven_by_code(plant, i)) continue;
      const reference::World before = reference_.save();
      if (reference_.set_input(i, 0)) inputs_.push_back(i);
      reference_.restore(before);
    }
    written_.resize(plant.symbols.size());
  }

  DrawnScenario write() {
    if (has_reversing_tracks(plant_)) return {steps_that_freeze_tracks(dice_, plant_.material), {}};
    if (has_restless_malfunctions(plant_)) return {steps_that_freeze_malfunctions(dice_), {}};
    const std::size_t large = plant_.units.size() > 100 ? 6 : plant_.units.size() > 20 ? 3 : 1;
    for (std::size_t i = 4 + dice_.below((8 + dice_.below(90)) / large); i > 0 && !ended_; --i) step();
    if (dice_.percent(25)) repeat();
    DrawnScenario drawn{std::move(steps_), {}};
    if (dice_.percent(35)) drawn.until = until();
    return drawn;
  }

 private:
  /// Plays the step; false, without effect, if it takes too long.
  bool play(const Step& step) {
    const auto resolved = resolver_.resolve(step);
    if (!resolved) return false;
    const reference::World world = reference_.save();
    const reference::ScenarioPlayer before = player_;
    player_.play(*resolved);
    if (!player_.exhausted()) return true;
    reference_.restore(world);
    player_ = before;
    return false;
  }
  /// Without effect. The step has a verdict.
  bool would_hold(const Step& step) {
    const reference::World world = reference_.save();
    const reference::ScenarioPlayer before = player_;
    const bool held = play(step) && player_.verdicts().back().held;
    reference_.restore(world);
    player_ = before;
    return held;
  }
  void take(Step step, tables::Time nominal) {
    if (!play(step)) {
      ended_ = ++refused_ == 4;
      return;
    }
    earliest_ = nominal;
    times_.push_back(reference_.now());
    steps_.push_back(std::move(step));
  }

  void step() {
    if (dice_.percent(12)) return wait();
    if (!condition_before_a_further_instant().empty() && dice_.percent(50)) return wait();
    Step step;
    timing(step);
    const tables::Time nominal = step.when == When::at ? *step.time : earliest_ + *step.time;
    actions(step);
    hands(step);
    add_starts(dice_, plant_, reference_.save(), fails_ != 0, step);
    if (dice_.percent(35)) expect(step);
    take(std::move(step), nominal);
  }

  void timing(Step& step) {
    static const std::vector<tables::Time> kPlus = {
        10 * kMillisecond, 10 * kMillisecond, 20 * kMillisecond, 50 * kMillisecond,
        5 * kMillisecond,  tables::kSecond,   33'333'333,        1};
    step.time = dice_.percent(40) ? 0 : dice_.pick(kPlus);
    const tables::Time now = reference_.now();
    const tables::Time due = reference_.next_due();
    // The exact time at which something happens.
    if (dice_.percent(25) && due < now + 100 * tables::kSecond) step.time = due - now;
    if (!dice_.percent(30)) return;
    step.when = When::at;
    // Later than the end of a long wait, but never earlier than the last time in the file.
    step.time = dice_.percent(25) ? earliest_ + *step.time : std::max(earliest_, now + *step.time);
  }

  void actions(Step& step) {
    std::set<std::uint32_t> touched;
    const auto is_new = [&](std::uint32_t symbol) {
      const std::uint32_t leader = plant_.symbols[symbol].leader;
      return touched.insert(leader == model::kNone ? symbol : leader).second;
    };
    for (std::size_t i = dice_.percent(80) ? 1 + dice_.below(3) : 0; i > 0; --i) {
      const auto& side = dice_.percent(85) || inputs_.empty() ? operations_ : inputs_;
      if (side.empty()) continue;
      const std::uint32_t symbol = dice_.pick(side);
      if (is_new(symbol)) step.set.emplace_back(name(symbol), new_value(symbol));
    }
    if (dice_.percent(35)) command(step, is_new);
    if (dice_.percent(6)) state(step);
    if (dice_.percent(8)) force(step);
    if (dice_.percent(10) && !forced_.empty()) release(step);
  }

  /// Parts by hand; without `fails_` only if that succeeds.
  void hands(Step& step) {
    add_hands(dice_, plant_.material, reference_.save(), step);
    if ((step.put.empty() && step.take.empty()) || fails_ != 0 || would_hold(step)) return;
    step.put.clear();
    step.take.clear();
  }

  /// One operation of a unit on, its other operations off.
  template <class IsNew>
  void command(Step& step, IsNew&& is_new) {
    if (plant_.units.empty()) return;
    const auto& operations = plant_.units[dice_.below(plant_.units.size())].operations;
    if (operations.empty()) return;
    const std::uint32_t wanted = dice_.pick(operations);
    for (const std::uint32_t symbol : operations) {
      if ((written_[symbol] != 0) == (symbol == wanted) || !is_new(symbol)) continue;
      written_[symbol] = symbol == wanted ? 1 : 0;
      step.set.emplace_back(name(symbol), written_[symbol]);
    }
  }

  void state(Step& step) {
    std::set<std::string_view> reported;
    for (std::size_t i = 1 + dice_.below(2); i > 0 && !plant_.units.empty(); --i) {
      const auto index = static_cast<std::uint32_t>(dice_.below(plant_.units.size()));
      const model::Unit& unit = plant_.units[index];
      if (!step.states.empty() && shares_an_address(plant_, index)) continue;
      if (unit.states.empty() || !reported.insert(unit.path).second) continue;
      step.states.emplace_back(unit.path, dice_.pick(unit.states).name);
    }
  }

  void force(Step& step) {
    const auto symbol = static_cast<std::uint32_t>(dice_.below(plant_.symbols.size()));
    step.force.emplace_back(name(symbol), random_content(dice_, plant_.symbols[symbol].type));
    forced_.push_back(name(symbol));
  }

  void release(Step& step) {
    for (std::size_t i = 1 + dice_.below(2); i > 0; --i) step.release.push_back(dice_.pick(forced_));
  }

  /// The values after the step; sometimes other values.
  void expect(Step& step) {
    Step only_looked_at = step;
    const reference::World world = reference_.save();
    const reference::ScenarioPlayer before = player_;
    only_looked_at.expect_condition = some_condition();
    if (only_looked_at.expect_condition.empty() || !play(only_looked_at)) return;
    const std::string& wanted = only_looked_at.expect_condition;
    const bool held = reference::holds(*resolver_.condition(wanted), reference_.save());
    const bool fails = dice_.percent(fails_);
    if (dice_.percent(35)) {
      step.expect_condition = held != fails ? wanted : "not (" + wanted + ")";
    } else {
      values(step, fails);
    }
    reference_.restore(world);
    player_ = before;
  }

  void values(Step& step, bool fails) {
    std::set<std::uint32_t> reported;
    for (std::size_t i = 1 + dice_.below(4); i > 0; --i) {
      const auto symbol = static_cast<std::uint32_t>(dice_.below(plant_.symbols.size()));
      const bool is_bit = plant_.symbols[symbol].type == tables::DataType::boolean;
      if (!reported.insert(symbol).second) continue;
      std::uint64_t value = reference_.value(symbol);
      if (fails && i == 1) value = is_bit ? 1 - value : random_content(dice_, plant_.symbols[symbol].type);
      step.expect.emplace_back(name(symbol), value);
    }
  }

  /// A condition that only the first instants of the present time meet may be waited for twice: both waits are met
  /// then.
  void wait() {
    const std::string passing = condition_before_a_further_instant();
    const std::string condition = passing.empty() ? some_condition() : passing;
    if (condition.empty()) return;
    const int waits = !passing.empty() && dice_.percent(50) ? 2 : 1;
    for (int i = 0; i < waits; ++i) {
      Step step;
      step.when = When::wait;
      step.wait = condition;
      if (dice_.percent(75)) step.time = wait_time(step);
      // Without `fails_` every wait is met.
      if (fails_ == 0 && !would_hold(step)) return;
      take(std::move(step), earliest_);
    }
  }

  /// Long, short, exactly enough, or one nanosecond too short.
  tables::Time wait_time(Step step) {
    if (dice_.percent(40)) return random_time(dice_) % (100 * tables::kSecond);
    const tables::Time start = reference_.now();
    const reference::World world = reference_.save();
    const reference::ScenarioPlayer before = player_;
    step.time = 10 * tables::kSecond;
    const bool met = play(step) && player_.verdicts().back().held;
    const tables::Time took = reference_.now() - start;
    reference_.restore(world);
    player_ = before;
    if (!met) return static_cast<tables::Time>(dice_.below(3)) * 15 * kMillisecond;
    return took > 0 && dice_.percent(25) ? took - 1 : took;
  }

  /// What the first of several instants at the present time shows and the last one does not; empty if there is nothing.
  std::string condition_before_a_further_instant() {
    const reference::World world = reference_.save();
    std::vector<reference::World> ends;
    reference_.advance_to(reference_.now(), &ends);
    reference_.restore(world);
    for (std::uint32_t i = 0; ends.size() > 1 && i < plant_.symbols.size(); ++i) {
      const std::uint64_t first = reference::effective(ends.front().symbols[i]);
      if (plant_.symbols[i].type != tables::DataType::boolean) continue;
      if (first != reference::effective(ends.back().symbols[i])) return (first != 0 ? "'" : "not '") + name(i) + "'";
    }
    return {};
  }

  std::string some_condition() {
    if (!plant_.material.empty() && dice_.percent(30)) return condition_of_parts(dice_, plant_.material);
    if (plan_.units.empty()) return {};
    for (int tries = 0; tries < 8; ++tries) {
      std::string text = random_condition(dice_, plan_, dice_.pick(plan_.units));
      if (resolver_.condition(text) != nullptr) return text;
    }
    return {};
  }

  tables::Time until() {
    const std::size_t kind = dice_.below(100);
    const tables::Time last = times_.empty() ? 0 : times_.back();
    if (kind < 40 || times_.empty()) return last + static_cast<tables::Time>(dice_.below(6)) * 10 * kMillisecond;
    const tables::Time some = dice_.pick(times_);
    if (kind < 70) return some;
    return kind < 85 ? some + 1 : std::max<tables::Time>(some - 1, 0);
  }

  std::string name(std::uint32_t symbol) const { return std::string(plant_.symbols[symbol].name()); }
  std::uint64_t new_value(std::uint32_t symbol) {
    if (plant_.symbols[symbol].type != tables::DataType::boolean) {
      return random_content(dice_, plant_.symbols[symbol].type);
    }
    return written_[symbol] = dice_.percent(90) ? 1 - written_[symbol] : written_[symbol];
  }

  Dice& dice_;
  const model::PlantModel& plant_;
  PlannedPlant plan_;
  StepResolver resolver_;
  reference::Plant reference_;
  reference::ScenarioPlayer player_;
  unsigned fails_;  ///< percent of expectations that are wrong
  std::vector<std::uint32_t> operations_;
  std::vector<std::uint32_t> inputs_;  ///< that no unit drives
  std::vector<std::uint64_t> written_;
  std::vector<std::string> forced_;
  /// Appends the last steps without `at` again, two or three times.
  void repeat() {
    std::size_t length = 0;
    while (length < 3 && length < steps_.size() && steps_[steps_.size() - 1 - length].when != Step::When::at) ++length;
    if (length == 0) return;
    const std::vector<Step> turn(steps_.end() - static_cast<std::ptrdiff_t>(length), steps_.end());
    for (std::size_t i = 2 + dice_.below(2); i > 0; --i) steps_.insert(steps_.end(), turn.begin(), turn.end());
  }

  std::vector<Step> steps_;
  std::vector<tables::Time> times_;  ///< end time of each step
  tables::Time earliest_ = 0;        ///< of the next `at`, as far as the file determines it
  int refused_ = 0;
  bool ended_ = false;
};

}  // namespace

long most_instants(const model::PlantModel& plant) {
  return has_reversing_tracks(plant) || has_restless_malfunctions(plant) ? 60'000 : 3000;
}

DrawnScenario random_scenario(std::uint64_t draw, std::uint64_t seed, const model::PlantModel& plant) {
  Dice dice(draw * 2 + 0x5CE4'0000'0000);
  return ScenarioDrawer(dice, seed, plant).write();
}

}  // namespace symplant::property::files
