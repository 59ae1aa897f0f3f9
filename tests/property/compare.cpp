// Runs the same actions on both plants and compares what they show.
#include "property/compare.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "lower/lower.hpp"
#include "property/behaviours.hpp"
#include "property/cycle_rises.hpp"
#include "property/differences.hpp"
#include "property/engine_plant.hpp"
#include "support/reference/reference.hpp"

namespace symplant::property {
namespace {

using Kind = Action::Kind;

/// An advance over more instants than this ends early: some plants have one every nanosecond.
constexpr int kMostInstants = 300;

class Run {
 public:
  Run(const model::PlantModel& plant, const tables::PlantTables& tables, bool with_behaviours, RunCounts& counts)
      : plant_(plant),
        tables_(tables),
        behaviours_(with_behaviours ? engine_behaviours(tables) : std::vector<engine::Behaviour>()),
        engine_(std::make_unique<EnginePlant>(tables, behaviours_)),
        twin_(std::make_unique<EnginePlant>(tables, behaviours_)),
        reference_(plant,
                   with_behaviours ? reference_behaviours(tables) : std::map<std::string, reference::Behaviour>()),
        counts_(counts),
        rises_(tables) {
    for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) symbols_.emplace(plant.symbols[i].name(), i);
    for (std::uint32_t i = 0; i < plant.units.size(); ++i) units_.emplace(plant.units[i].path, i);
  }

  const reference::Plant& reference() const { return reference_; }

  /// The first difference after an action; empty if there is no difference.
  std::string act(const Action& action) {
    if (ended_) return {};
    switch (action.kind) {
      case Kind::reset:
        return reset(action);
      case Kind::set:
      case Kind::set_input:
      case Kind::force:
      case Kind::release:
        return of_symbol(action);
      case Kind::set_state:
        return set_state(action);
      case Kind::set_quality:
        for (EnginePlant* engine : both()) engine->plant().set_quality(action.value != 0);
        reference_.set_quality(action.value != 0);
        ++counts_.qualities;
        return {};
      case Kind::save:
        return save();
      case Kind::restore:
        return restore(action);
      case Kind::advance:
      case Kind::advance_to_due:
      case Kind::advance_before:
        return advance(action);
    }
    return {};
  }

 private:
  struct Saved {
    std::vector<std::byte> engine;
    std::vector<std::byte> twin;
    reference::World reference;
    CycleRises rises;
  };

  std::array<EnginePlant*, 2> both() { return {engine_.get(), twin_.get()}; }

  std::string reset(const Action& action) {
    for (EnginePlant* engine : both()) engine->plant().reset(action.value, action.time);
    reference_.reset(action.value, action.time);
    rises_.clear();
    ++counts_.resets;
    return next_due_difference(engine_->plant(), reference_);
  }

  std::string of_symbol(const Action& action) {
    const auto found = symbols_.find(action.what);
    if (found == symbols_.end()) return {};
    const std::uint32_t symbol = found->second;
    const bool operation = plant_.symbols[symbol].direction == tables::Direction::operation;
    if (action.kind == Kind::set) {
      if (!operation) return {};
      for (EnginePlant* engine : both()) engine->write(symbol, action.value);
      reference_.set_operation(symbol, action.value);
    } else if (action.kind == Kind::force) {
      for (EnginePlant* engine : both()) engine->plant().force(symbol, action.value);
      reference_.force(symbol, action.value);
      ++counts_.forces;
    } else if (action.kind == Kind::release) {
      for (EnginePlant* engine : both()) engine->plant().release(symbol);
      reference_.release(symbol);
    } else {
      const bool done = engine_->plant().set_input(symbol, action.value);
      twin_->plant().set_input(symbol, action.value);
      if (done != reference_.set_input(symbol, action.value)) {
        return "set_input says " + std::string(done ? "true" : "false") + ", the reference the contrary";
      }
      ++(done ? counts_.inputs : counts_.inputs_refused);
    }
    if (engine_->plant().is_forced(symbol) != reference_.is_forced(symbol)) return "is_forced";
    return {};
  }

  std::string set_state(const Action& action) {
    const auto found = units_.find(action.what);
    if (found == units_.end() || action.value >= plant_.units[found->second].states.size()) return {};
    for (EnginePlant* engine : both()) {
      engine->plant().set_state(found->second, static_cast<std::uint8_t>(action.value));
    }
    reference_.set_state(found->second, static_cast<std::uint8_t>(action.value));
    return {};
  }

  std::string save() {
    const auto block = engine_->plant().save();
    const auto twin = twin_->plant().save();
    saves_.push_back({{block.begin(), block.end()}, {twin.begin(), twin.end()}, reference_.save(), rises_});
    ++counts_.saves;
    return {};
  }

  std::string restore(const Action& action) {
    if (saves_.empty()) return {};
    const Saved& saved = saves_[action.value % saves_.size()];
    const bool elsewhere = action.time != 0;
    if (elsewhere) {  // into new plants, each the block of the other
      engine_ = std::make_unique<EnginePlant>(tables_, behaviours_);
      twin_ = std::make_unique<EnginePlant>(tables_, behaviours_);
      ++counts_.restores_elsewhere;
    }
    const bool restored = engine_->plant().restore(elsewhere ? saved.twin : saved.engine) &&
                          twin_->plant().restore(elsewhere ? saved.engine : saved.twin);
    if (!restored) return "restore() rejects a block of the same model";
    reference_.restore(saved.reference);
    rises_ = saved.rises;
    ++counts_.restores;
    return {};
  }

  /// The reference first, instant by instant, so that the run can be cut short if instants never end.
  std::string advance(const Action& action) {
    ++counts_.advances;
    const tables::Time target = target_of(action);
    const bool before = action.kind == Kind::advance_before;
    if (before && target == reference_.now()) return {};  // the action takes effect in the pending instant
    tables::Time reached = target;
    reference_.clear_instants();
    for (int i = 0;; ++i) {
      const tables::Time due = reference_.next_due();
      if (due >= target) break;
      if (i == kMostInstants) {
        reached = reference_.now();
        ++counts_.cut_short;
        break;
      }
      reference_.advance_before(due + 1);
    }
    if (before) {
      reference_.advance_before(reached);
    } else {
      reference_.advance_to(reached);
    }
    counts_.instants += std::ssize(reference_.instants());
    ended_ = rises_.too_many(reference_.instants(), reference_.save().cycle);
    if (ended_) ++counts_.too_many_rises;
    if (ended_) return {};
    return engine_follows(reached, before);
  }

  std::string engine_follows(tables::Time reached, bool before) {
    const Shadow shadow(*engine_, plant_);
    const bool twin_observed = counts_.advances % 4 == 0;  // so that both kinds of instants follow each other
    for (EnginePlant* engine : both()) {
      const bool observed = engine == engine_.get() || twin_observed;
      engine->forget();
      engine->plant().forget_changed_events();
      if (before) {
        engine->advance_before(reached, observed);
      } else {
        engine->advance_to(reached, observed);
      }
    }
    std::string text = instants_difference(*engine_, reference_, plant_);
    if (text.empty()) text = state_difference(*engine_, reference_, plant_);
    if (text.empty()) text = shadow.difference(*engine_);
    if (text.empty() && twin_observed) text = instants_difference(*twin_, reference_, plant_);
    if (text.empty()) text = twin_difference(*engine_, *twin_);
    return text;
  }

  tables::Time target_of(const Action& action) {
    const tables::Time now = reference_.now();
    tables::Time step = action.time;
    if (action.kind == Kind::advance_to_due) {
      const tables::Time due = reference_.next_due();
      if (due < tables::kNever / 2) return due;
      step = tables::kSecond;
    }
    return now > tables::kNever - 1 - step ? tables::kNever - 1 : now + step;
  }

  const model::PlantModel& plant_;
  const tables::PlantTables& tables_;
  std::vector<engine::Behaviour> behaviours_;
  std::unique_ptr<EnginePlant> engine_;  ///< always observed
  std::unique_ptr<EnginePlant> twin_;    ///< the same plant, not always observed
  reference::Plant reference_;
  RunCounts& counts_;
  CycleRises rises_;
  bool ended_ = false;  ///< the engine no longer needs to equal the reference
  std::vector<Saved> saves_;
  std::unordered_map<std::string_view, std::uint32_t> symbols_;
  std::unordered_map<std::string_view, std::uint32_t> units_;
};

}  // namespace

RunCounts& RunCounts::operator+=(const RunCounts& other) {
  instants += other.instants;
  advances += other.advances;
  saves += other.saves;
  restores += other.restores;
  restores_elsewhere += other.restores_elsewhere;
  resets += other.resets;
  inputs += other.inputs;
  inputs_refused += other.inputs_refused;
  forces += other.forces;
  qualities += other.qualities;
  cut_short += other.cut_short;
  too_many_rises += other.too_many_rises;
  return *this;
}

std::optional<Difference> run_case(const model::PlantModel& plant, const tables::PlantTables& tables,
                                   const std::vector<Action>& actions, bool with_behaviours,
                                   reference::Counters& counters, RunCounts& counts) {
  Run run(plant, tables, with_behaviours, counts);
  std::string text = run.reference().difference_from_model();
  if (!text.empty()) return Difference{actions.size(), "the model: " + text};
  std::optional<Difference> difference;
  for (std::size_t i = 0; i < actions.size() && !difference; ++i) {
    text = run.act(actions[i]);
    if (!text.empty()) difference = Difference{i, std::move(text)};
  }
  counters += run.reference().counters;
  return difference;
}

std::optional<Difference> run_case(const Case& the_case, reference::Counters& counters, RunCounts& counts) {
  const model::Derived derived = build(the_case.plant);
  const model::PlantModel& plant = derived.plant;
  if (!runnable(derived)) return std::nullopt;
  const lower::EngineTables tables = lower::lower(plant);
  const tables::PlantTables rows = tables.tables();
  return run_case(plant, rows, the_case.actions, true, counters, counts);
}

}  // namespace symplant::property
