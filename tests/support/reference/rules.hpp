// What the reference derives from a plant's names and description: the constant part of its behavior.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"
#include "support/reference/behaviour.hpp"
#include "support/reference/value_rules.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::reference {

inline constexpr std::uint32_t kNone = 0xFFFF'FFFF;

/// A transition of a unit's table. One that is neither automatic nor has an `on` is a spring return.
struct Transition {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  std::uint32_t on = kNone;  ///< index in UnitRules::operations
  bool automatic = false;
  bool once = false;
  description::Duration after;
  description::Duration takes;
  Formula after_formula = {};  ///< of an `after` in seconds
  Formula takes_formula = {};
  std::uint32_t when = kNone;    ///< index in UnitRules::conditions
  std::uint32_t during = kNone;  ///< `while`, as `when`
  std::uint32_t weight = 0;      ///< 0: none

  bool commanded() const { return on != kNone; }
};

struct StateRules {
  std::string name;
  std::uint32_t operation = kNone;                    ///< index in UnitRules::operations
  std::uint32_t event = kNone;                        ///< index in UnitRules::events
  std::vector<std::pair<std::uint32_t, bool>> enter;  ///< events to switch, in this order, starting with its own
  std::vector<std::pair<std::uint32_t, bool>> leave;
  std::vector<std::uint32_t> disables;  ///< units
  bool numbered = true;                 ///< digits at its end are a sequence number; not of an added rest state
};

struct UnitRules {
  std::string path;
  const description::DeviceDescription* described = nullptr;
  const Behaviour* behaviour = nullptr;
  std::vector<std::uint32_t> operations;  ///< symbols
  std::vector<std::uint32_t> events;      ///< symbols
  std::set<std::uint32_t> reports;        ///< events that name no state by themselves
  std::vector<std::uint32_t> values;      ///< numeric symbols of the device
  std::vector<StateRules> states;
  std::vector<Transition> transitions;
  std::vector<const condition::Tree*> conditions;  ///< of the distinct texts of `when` and `while`, then of the inputs
  std::uint32_t first_input = 0;
  tables::Actuation actuation = tables::Actuation::latched;
  std::uint32_t rest = kNone;      ///< of a spring
  std::uint32_t any_rest = kNone;  ///< also the inferred one of a unit that is no spring
  std::uint8_t initial = 0;
  tables::Time travel = tables::kSecond;
  tables::Time overrun = tables::kNever;  ///< kNever: not examined
  bool sequence = true;                   ///< digits at the end of states are sequence numbers
  bool archetype = false;                 ///< the naming rule gives the model
  bool no_states = false;                 ///< nothing names a state: it has the state IDLE
  std::vector<std::string> order = {};    ///< states that come first in S, by the naming rule

  /// The sequence number of a state; empty without one.
  std::string number_of(const StateRules& state) const;
  bool spring() const { return actuation == tables::Actuation::spring; }
  /// The operation has the state's name, or commands a transition to it.
  bool leads_to(std::uint32_t operation, std::uint8_t state) const;
  bool event_is_a_state(std::uint32_t event) const;
};

/// An event of no unit whose level is the truth of a condition.
struct FollowRules {
  std::uint32_t symbol = kNone;
  std::uint32_t given = kNone;  ///< index in Description::follow
  const condition::Tree* condition = nullptr;
  const condition::Tree* off = nullptr;  ///< with hysteresis
};

struct Rules {
  const model::PlantModel* model = nullptr;
  std::map<std::string, Behaviour> behaviours;
  std::vector<UnitRules> units;
  std::vector<bool> inverted;        ///< symbols
  std::vector<FollowRules> follows;  ///< in list order
  std::vector<ValueRules> values;    ///< in the order of the file
  std::vector<SignalRules> signals;  ///< in list order
  std::string fault;                 ///< names in the description that the reference does not find; empty if none

  std::uint32_t leader(std::uint32_t symbol) const;
  /// All symbols of one address that are kept equal, including itself.
  std::vector<std::uint32_t> together(std::uint32_t symbol) const;
  bool is_bool(std::uint32_t symbol) const { return model->symbols[symbol].type == tables::DataType::boolean; }
  bool is_operation(std::uint32_t symbol) const {
    return model->symbols[symbol].direction == tables::Direction::operation;
  }
  /// The bit of a symbol's level, or the level of its bit. A number is unchanged.
  std::uint64_t turned(std::uint32_t symbol, std::uint64_t value) const { return inverted[symbol] ? value ^ 1 : value; }
  bool follows_condition(std::uint32_t symbol) const;
  /// An event that its unit or a condition switches, or one on the address of such an event.
  bool moved(std::uint32_t symbol) const;
};

Rules derive(const model::PlantModel& model, std::map<std::string, Behaviour> behaviours);

/// Which symbols are inverted, and which follow a condition.
void derive_symbols(Rules& rules);

/// The parts of derive(), one unit per call.
void derive_states(Rules& rules, UnitRules& unit);
void derive_actuation_and_initial(Rules& rules, UnitRules& unit);
void derive_transitions(Rules& rules, UnitRules& unit);

/// Names are compared ignoring the case of ASCII letters.
bool same_name(std::string_view a, std::string_view b);
std::string upper(std::string_view name);
/// The decimal digits at a name's end without leading zeros ("0" if all are zeros); empty if there are no digits.
std::string sequence_number(std::string_view name);
bool lower_number(const std::string& a, const std::string& b);

std::uint32_t find_state(const UnitRules& unit, std::string_view name);
std::uint32_t find_operation(const Rules& rules, const UnitRules& unit, std::string_view task);
std::uint32_t find_event(const Rules& rules, const UnitRules& unit, std::string_view task);

}  // namespace symplant::reference
