// Plants built by hand, for tests of the engine alone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "symplant/plant/owned_plant.hpp"

namespace symplant::test {

/// One transition of a unit, with its times.
struct Route {
  std::uint8_t from;
  std::uint8_t to;
  std::uint8_t on;  ///< tables::kNoOperation: automatic
  tables::Time after;
  tables::Time takes;
};

/// A unit whose states 0 .. n-1 each have an event of the same number.
struct HandUnit {
  std::uint8_t states;
  std::vector<std::uint8_t> operation_targets;  ///< for each operation, the state of its name, or tables::kNoState
  std::vector<Route> routes;
  tables::Actuation actuation = tables::Actuation::latched;
  std::uint8_t rest = tables::kNoState;
  std::uint8_t initial = 0;
  tables::Time travel = tables::kSecond;
};

/// Every unit has a separate type and separate words: unit u has bits 64 u ... in both planes.
class HandPlant {
 public:
  explicit HandPlant(const std::vector<HandUnit>& units) {
    types_.reserve(units.size());
    for (const HandUnit& unit : units) add(unit);
    for (std::size_t i = 0; i < units.size(); ++i) {
      const HandUnit& unit = units[i];
      Parts& parts = parts_[i];
      types_.push_back({static_cast<std::uint8_t>(unit.operation_targets.size()), unit.states, unit.states, unit.rest,
                        unit.actuation, parts.transitions, parts.enter, parts.leave, parts.targets, parts.times, 0});
    }
    tables.types = types_;
    tables.units = rows_;
    tables.operation_bits = tables.event_bits = static_cast<std::uint32_t>(64 * units.size());
    plant = std::make_unique<plant::OwnedPlant>(tables);
  }

  void set(std::uint32_t unit, std::uint32_t operation, bool on) { plant->set_operation(64 * unit + operation, on); }
  bool event(std::uint32_t unit, std::uint32_t event) const { return plant->event(64 * unit + event); }
  plant::UnitView unit(std::uint32_t u) const { return plant->unit(u); }
  void to(tables::Time time, engine::Observer* observer = nullptr) { plant->advance_to(time, observer); }

  tables::PlantTables tables{};
  std::unique_ptr<plant::OwnedPlant> plant;

 private:
  struct Parts {
    std::vector<tables::Transition> transitions;
    std::vector<tables::EventMasks> enter;
    std::vector<tables::EventMasks> leave;
    std::vector<std::uint8_t> targets;
    std::vector<tables::TransitionTimes> times;  ///< of a move without a transition, then of each transition
  };

  void add(const HandUnit& unit) {
    const auto bit = static_cast<std::uint32_t>(64 * rows_.size());
    const bool timed = std::any_of(unit.routes.begin(), unit.routes.end(),
                                   [](const Route& transition) { return transition.after != 0; });
    rows_.push_back({static_cast<std::uint32_t>(rows_.size()) & 0x7F'FFFF, unit.initial, timed ? 1U : 0U, bit, bit, 0});
    Parts& parts = parts_[rows_.size() - 1];
    parts.times.push_back({0, unit.travel});
    for (const Route& transition : unit.routes) {
      parts.transitions.push_back({transition.from, transition.to, transition.on, false, tables::kNoCondition, timed,
                                   static_cast<std::uint16_t>(parts.times.size())});
      parts.times.push_back({transition.after, transition.takes});
    }
    for (std::uint8_t s = 0; s < unit.states; ++s) {
      parts.enter.push_back({std::uint64_t{1} << s, 0});
      parts.leave.push_back({0, std::uint64_t{1} << s});
    }
    parts.targets = unit.operation_targets;
  }

  std::map<std::size_t, Parts> parts_;  // nodes do not move
  std::vector<tables::TypeRow> types_;
  std::vector<tables::UnitRow> rows_;
};

}  // namespace symplant::test
