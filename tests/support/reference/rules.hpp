// What the reference derives from a plant's names and description: everything about its behaviour that never changes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"
#include "support/reference/behaviour.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::reference {

inline constexpr std::uint32_t kNone = 0xFFFF'FFFF;

/// A transition of a unit's table. What is neither automatic nor has an `on` is a spring's own way.
struct Transition {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  std::uint32_t on = kNone;  ///< a place in UnitRules::operations
  bool automatic = false;
  bool once = false;
  description::Duration after;
  description::Duration takes;
  std::uint32_t when = kNone;  ///< a place in UnitRules::conditions

  bool commanded() const { return on != kNone; }
};

struct StateRules {
  std::string name;
  std::uint32_t operation = kNone;                    ///< a place in UnitRules::operations
  std::uint32_t event = kNone;                        ///< a place in UnitRules::events
  std::vector<std::pair<std::uint32_t, bool>> enter;  ///< events to switch, in this order, its own first
  std::vector<std::pair<std::uint32_t, bool>> leave;
  std::vector<std::uint32_t> disables;  ///< units
};

struct UnitRules {
  std::string path;
  const description::DeviceDescription* described = nullptr;
  const Behaviour* behaviour = nullptr;
  std::vector<std::uint32_t> operations;  ///< symbols
  std::vector<std::uint32_t> events;      ///< symbols
  std::vector<std::uint32_t> values;      ///< symbols: numeric ones of the device
  std::vector<StateRules> states;
  std::vector<Transition> transitions;
  std::vector<const condition::Tree*> conditions;  ///< of the distinct texts of `when`, then of the inputs
  std::uint32_t first_input = 0;
  tables::Actuation actuation = tables::Actuation::latched;
  std::uint32_t rest = kNone;  ///< of a spring
  std::uint8_t initial = 0;
  tables::Time travel = tables::kSecond;

  bool spring() const { return actuation == tables::Actuation::spring; }
  /// The operation is named like the state, or commands a way to it.
  bool leads_to(std::uint32_t operation, std::uint8_t state) const;
  bool event_is_a_state(std::uint32_t event) const;
};

struct Rules {
  const model::PlantModel* model = nullptr;
  std::map<std::string, Behaviour> behaviours;
  std::vector<UnitRules> units;
  std::string fault;  ///< what the description names and the reference does not find; empty where nothing

  std::uint32_t leader(std::uint32_t symbol) const;
  /// All symbols of one address that are kept equal, itself included.
  std::vector<std::uint32_t> together(std::uint32_t symbol) const;
  bool is_bool(std::uint32_t symbol) const { return model->symbols[symbol].type == tables::DataType::boolean; }
  bool is_operation(std::uint32_t symbol) const {
    return model->symbols[symbol].direction == tables::Direction::operation;
  }
  /// An event that its unit switches, or one that follows such a one.
  bool moved(std::uint32_t symbol) const;
};

Rules derive(const model::PlantModel& model, std::map<std::string, Behaviour> behaviours);

/// The parts of derive(), a unit each.
void derive_states(Rules& rules, UnitRules& unit);
void derive_actuation_and_initial(Rules& rules, UnitRules& unit);
void derive_transitions(Rules& rules, UnitRules& unit);

/// Names compare without regard to the case of ASCII letters.
bool same_name(std::string_view a, std::string_view b);
std::string upper(std::string_view name);
/// The decimal digits at a name's end without leading zeros ("0" where they are all zeros); empty where it has none.
std::string sequence_number(std::string_view name);
bool lower_number(const std::string& a, const std::string& b);

std::uint32_t find_state(const UnitRules& unit, std::string_view name);
std::uint32_t find_operation(const Rules& rules, const UnitRules& unit, std::string_view task);
std::uint32_t find_event(const Rules& rules, const UnitRules& unit, std::string_view task);

}  // namespace symplant::reference
