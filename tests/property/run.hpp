// Engine and reference that do the same actions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "property/behaviours.hpp"
#include "property/compare.hpp"
#include "property/cycle_rises.hpp"
#include "property/differences.hpp"
#include "property/engine_plant.hpp"
#include "property/malfunction_names.hpp"
#include "property/part_differences.hpp"
#include "property/value_differences.hpp"
#include "support/reference/reference.hpp"

namespace symplant::property {

class Run {
 public:
  /// An advance over more instants than this ends early: some plants have one every nanosecond.
  static constexpr int kMostInstants = 300;

  /// `further`: the actions have further instants.
  Run(const model::PlantModel& plant, const tables::PlantTables& tables, bool with_behaviours, bool further,
      RunCounts& counts)
      : plant_(plant),
        tables_(tables),
        behaviours_(with_behaviours ? engine_behaviours(tables) : std::vector<engine::Behaviour>()),
        engine_(std::make_unique<EnginePlant>(tables, behaviours_)),
        twin_(std::make_unique<EnginePlant>(tables, behaviours_)),
        reference_(plant,
                   with_behaviours ? reference_behaviours(tables) : std::map<std::string, reference::Behaviour>()),
        counts_(counts),
        rises_(tables) {
    if (further) {
      undisturbed_ = std::make_unique<reference::Plant>(
          plant, with_behaviours ? reference_behaviours(tables) : std::map<std::string, reference::Behaviour>());
    }
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
        for (reference::Plant* reference : references()) reference->set_quality(action.value != 0);
        ++counts_.qualities;
        return {};
      case Kind::save:
        return save();
      case Kind::restore:
        return restore(action);
      case Kind::advance:
      case Kind::advance_to_due:
      case Kind::advance_before:
      case Kind::run:
        return advance(action);
      case Kind::put:
      case Kind::take:
        return part_by_hand(action);
      case Kind::start:
      case Kind::stop:
        return malfunction(action);
      case Kind::further:
        return further(action);
      case Kind::set_value:
        return set_value(action);
    }
    return {};
  }

 private:
  using Kind = Action::Kind;

  struct Saved {
    std::vector<std::byte> engine;
    std::vector<std::byte> twin;
    reference::World reference;
    std::optional<reference::World> undisturbed;
    CycleRises rises;
    ValueTrace values;
  };

  std::array<EnginePlant*, 2> both() { return {engine_.get(), twin_.get()}; }

  std::vector<reference::Plant*> references() {
    if (undisturbed_ == nullptr) return {&reference_};
    return {&reference_, undisturbed_.get()};
  }

  std::string reset(const Action& action) {
    for (EnginePlant* engine : both()) {
      engine->plant().reset(action.value, action.time);
      engine->value_trace().clear();
    }
    for (reference::Plant* reference : references()) reference->reset(action.value, action.time);
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
      for (reference::Plant* reference : references()) reference->set_operation(symbol, action.value);
    } else if (action.kind == Kind::force) {
      for (EnginePlant* engine : both()) engine->plant().force(symbol, action.value);
      for (reference::Plant* reference : references()) reference->force(symbol, action.value);
      ++counts_.forces;
    } else if (action.kind == Kind::release) {
      for (EnginePlant* engine : both()) engine->plant().release(symbol);
      for (reference::Plant* reference : references()) reference->release(symbol);
    } else {
      const bool done = engine_->plant().set_input(symbol, action.value);
      twin_->plant().set_input(symbol, action.value);
      if (undisturbed_ != nullptr) undisturbed_->set_input(symbol, action.value);
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
    for (reference::Plant* reference : references()) {
      reference->set_state(found->second, static_cast<std::uint8_t>(action.value));
    }
    return {};
  }

  std::string part_by_hand(const Action& action) {
    const auto location = part_location(plant_.material, action.what);
    if (!location || (action.kind == Kind::put && action.value >= plant_.material.kinds.size())) return {};
    const auto kind = static_cast<std::uint32_t>(action.value);
    const auto act = [&](auto& plant) {
      return action.kind == Kind::put ? plant.put(*location, kind) : plant.take(*location);
    };
    const bool done = act(engine_->plant());
    act(twin_->plant());
    if (undisturbed_ != nullptr) act(*undisturbed_);
    if (done == act(reference_)) return {};
    return (action.kind == Kind::put ? "put says " : "take says ") + std::string(done ? "true" : "false") +
           ", the reference the contrary";
  }

  std::string malfunction(const Action& action) {
    const auto number = malfunction_number(plant_, action.what);
    if (!number) return {};
    using By = engine::MalfunctionChange::By;
    const By by = action.value == 0 ? By::scenario : By::hand;
    const auto act = [&](auto& plant) {
      return action.kind == Kind::start ? plant.start_malfunction(*number, by) : plant.stop_malfunction(*number, by);
    };
    const bool done = act(engine_->plant());
    act(twin_->plant());
    if (undisturbed_ != nullptr) act(*undisturbed_);
    ++counts_.malfunctions;
    if (done == act(reference_)) return {};
    return "malfunction says " + std::string(done ? "true" : "false") + ", the reference the contrary";
  }

  std::string set_value(const Action& action) {
    const double number = std::bit_cast<double>(action.value);
    const auto value = value_number(plant_, action.what);
    if (!value) return reference_.set_value(action.what, number) ? "set_value of an unknown value" : "";
    const bool done = engine_->plant().set_value(*value, number);
    twin_->plant().set_value(*value, number);
    if (undisturbed_ != nullptr) undisturbed_->set_value(action.what, number);
    ++(done ? counts_.values : counts_.values_refused);
    if (done == reference_.set_value(action.what, number)) return {};
    return "set_value says " + std::string(done ? "true" : "false") + ", the reference the contrary";
  }

  /// One more instant, for all but the undisturbed reference.
  std::string further(const Action& action) {
    const auto found = symbols_.find(action.what);
    if (found == symbols_.end() || undisturbed_ == nullptr || reference_.is_forced(found->second)) return {};
    const std::uint32_t symbol = found->second;
    const bool operation = plant_.symbols[symbol].direction == tables::Direction::operation;
    const bool write = operation && action.value == 0;
    std::string text = advance({write ? Kind::advance : Kind::advance_before, {}, 0, action.time});
    if (!text.empty() || ended_) return text;
    const std::uint64_t value = reference_.save().symbols[symbol].written;
    for (EnginePlant* engine : both()) {
      if (write) engine->write(symbol, value);
      if (!write) engine->plant().release(symbol);
    }
    if (write) reference_.set_operation(symbol, value);
    if (!write) reference_.release(symbol);
    ++counts_.furthers;
    return write ? advance({Kind::advance, {}, 0, 0}) : "";
  }

  std::string save() {
    const auto block = engine_->plant().save();
    const auto twin = twin_->plant().save();
    saves_.push_back({{block.begin(), block.end()},
                      {twin.begin(), twin.end()},
                      reference_.save(),
                      {},
                      rises_,
                      engine_->value_trace()});
    if (undisturbed_ != nullptr) saves_.back().undisturbed = undisturbed_->save();
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
      engine_->plant().reset(0, reference_.save().cycle);
      twin_->plant().reset(0, reference_.save().cycle);
      ++counts_.restores_elsewhere;
    }
    const bool restored = engine_->plant().restore(elsewhere ? saved.twin : saved.engine) &&
                          twin_->plant().restore(elsewhere ? saved.engine : saved.twin);
    if (!restored) return "restore() rejects a block of the same model";
    reference_.restore(saved.reference);
    if (undisturbed_ != nullptr) undisturbed_->restore(*saved.undisturbed);
    rises_ = saved.rises;
    for (EnginePlant* engine : both()) engine->value_trace() = saved.values;
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
    for (reference::Plant* reference : references()) {
      reference->clear_instants();
      reference->end_cycle();  // as engine_follows() does
    }
    const int most = action.kind == Kind::run ? static_cast<int>(action.value) : kMostInstants;
    for (int i = 0;; ++i) {
      const tables::Time due = reference_.next_due();
      if (due >= target) break;
      if (i == most) {
        reached = reference_.now();
        ++counts_.cut_short;
        break;
      }
      reference_.advance_before(due + 1);
    }
    for (reference::Plant* reference : references()) {
      if (before) {
        reference->advance_before(reached);
      } else {
        reference->advance_to(reached);
      }
    }
    counts_.instants += std::ssize(reference_.instants());
    ended_ = rises_.too_many(reference_.instants(), reference_.save().cycle);
    if (ended_) ++counts_.too_many_rises;
    if (ended_) return {};
    const std::string text = engine_follows(reached, before);
    return text.empty() && undisturbed_ != nullptr ? disturbance(*undisturbed_, reference_, plant_) : text;
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
    twin_->value_trace() = engine_->value_trace();  // as if it had been observed
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
  std::unique_ptr<reference::Plant> undisturbed_;  ///< without further instants; null if there are none
  RunCounts& counts_;
  CycleRises rises_;
  bool ended_ = false;  ///< the engine no longer needs to equal the reference
  std::vector<Saved> saves_;
  std::unordered_map<std::string_view, std::uint32_t> symbols_;
  std::unordered_map<std::string_view, std::uint32_t> units_;
};

}  // namespace symplant::property
