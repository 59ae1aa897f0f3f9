// The plant as derived from symbol lists: symbols, units and their I/O models. Immutable once built.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "address/address.hpp"
#include "description/description.hpp"
#include "description/plant_source.hpp"
#include "elements/alarm/model.hpp"
#include "elements/follow/model.hpp"
#include "elements/link/model.hpp"
#include "elements/malfunction/model.hpp"
#include "elements/material/model.hpp"
#include "elements/requirement/model.hpp"
#include "elements/signal/model.hpp"
#include "elements/value/model.hpp"
#include "name/symbol_reader.hpp"
#include "pairing/pairing.hpp"
#include "read/symbol_table.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::model {

using tables::kNone;

/// Why a row of the list is not an I/O symbol. Such rows are only counted.
enum class InternalReason : std::uint8_t {
  constant,      ///< VAR_CONSTANT and the like
  memory,        ///< an address in the PLC's memory: M, D, %M
  type,          ///< TIME, STRING, an array, a structure, a function block
  no_direction,  ///< no address, and a name without a direction
};
inline constexpr std::size_t kInternalReasons = 4;
std::string_view internal_reason_text(InternalReason reason);

using name::Account;

/// What gave a symbol its direction.
enum class DirectionBy : std::uint8_t {
  name,         ///< its name: it has no address
  address,      ///< the address in the list
  alias,        ///< the address of the operand that it is an alias of
  description,  ///< plant.json or `--io`: its address is internal or missing
};

/// The levels of a symbol's device and its task in it. All are empty if no naming rule reads the symbol.
class SymbolReading {
 public:
  SymbolReading() = default;
  /// What is given must outlive the reading; null levels: no rule reads the symbol.
  SymbolReading(const name::DeviceLevels* levels, std::string_view task) : levels_(levels), task_(task) {}

  /// Whether a rule reads the symbol, and gives it a direction.
  bool is_named() const { return levels_ != nullptr; }
  std::string_view line() const { return levels_ == nullptr ? std::string_view() : levels_->line; }
  std::string_view process() const { return levels_ == nullptr ? std::string_view() : levels_->process; }
  std::string_view device() const { return levels_ == nullptr ? std::string_view() : levels_->device; }
  /// Line, process and device, those that are not empty, joined by `_`: identifies the device.
  std::string_view device_path() const { return levels_ == nullptr ? std::string_view() : levels_->path; }
  std::string_view task() const { return task_; }
  const name::DeviceLevels* levels() const { return levels_; }

 private:
  const name::DeviceLevels* levels_ = nullptr;
  std::string_view task_;
};

/// One I/O symbol, which points into its list. There may be millions: mind the size.
struct Symbol {
  const read::ListRow* row = nullptr;
  SymbolReading reading;
  std::optional<address::Address> address;
  std::uint64_t initial = 0;  ///< in the form of tables::InitialValue; 0 if the list has none
  std::uint32_t list = 0;     ///< index in PlantModel::lists
  std::uint32_t unit = kNone;
  std::uint32_t value_of = kNone;  ///< of a number: the unit that has the name of its device, or kNone
  std::uint32_t leader = kNone;    ///< the symbol on its address whose value it follows; kNone: it leads
  tables::Direction direction{};
  DirectionBy direction_by = DirectionBy::name;
  tables::DataType type{};
  tables::Direction named{};  ///< the direction that its name says; without one, `direction`
  Account account = Account::modelled;
  bool address_is_iec = false;  ///< `address` is that of the cell for IEC addresses
  bool initial_known = true;    ///< false: its Initial could not be read
  bool inverted = false;        ///< its bit is on while what it means is off
  bool described = false;       ///< the description gives its device and task, whatever its name

  std::string_view name() const { return row->name; }
  /// The unit that it is in, or whose value it is; else kNone.
  std::uint32_t unit_of_device() const { return unit != kNone ? unit : value_of; }
  /// The cell that `address` was read from; empty without an address.
  std::string_view address_cell() const {
    return !address ? std::string_view() : address_is_iec ? row->iec_address : row->vendor_address;
  }
  /// Whether a condition or parts drive it: then it is in no unit.
  bool driven_without_unit() const {
    return account == Account::follows || account == Account::senses_parts || account == Account::shows_value;
  }
  /// Whether the naming rule does not apply: its device or what drives it is given, or it is given that it has no
  /// device.
  bool is_given() const { return described || driven_without_unit() || account == Account::plain; }
  /// Whether a person operates it, by the role `operator` of the naming rule: a button, a selector.
  bool is_by_operator() const { return account == Account::operator_panel && direction == tables::Direction::event; }
  /// The address as the list writes it: the vendor's, else the IEC one; empty if there is none.
  std::string_view written_address() const {
    return row->vendor_address.empty() ? row->iec_address : row->vendor_address;
  }
};

/// A state of a unit. Operation and event are indexes in Unit::operations and Unit::events.
struct State {
  std::string name;
  std::uint32_t operation = kNone;
  std::uint32_t event = kNone;
  bool numbered = false;  ///< its name ends in a sequence number
};

/// The origin of a transition. Transitions are also sorted by it.
enum class Origin : std::uint8_t { given, derived, inferred };

/// A transition between two states, which are indexes in Unit::states.
struct Transition {
  std::uint32_t from = kNone;
  std::uint32_t to = kNone;
  std::uint32_t on = kNone;  ///< index in Unit::operations; kNone if automatic or a spring return
  description::Duration after;
  description::Duration takes;
  Origin origin = Origin::derived;
  bool spring_return = false;  ///< only sets the travel time of a spring return
  bool once = false;
  std::uint32_t when = kNone;    ///< index in Unit::conditions
  std::uint32_t during = kNone;  ///< `while`: index in Unit::conditions
  tables::TransitionNumbers numbers = {};
  std::uint32_t given = kNone;  ///< index in DeviceDescription::transitions
};

/// Events that l_enter or l_leave switches besides that of the state, by index in Unit::events, in this order.
struct Outputs {
  std::vector<std::pair<std::uint32_t, bool>> enter;
  std::vector<std::pair<std::uint32_t, bool>> leave;
};

/// The rule that decided the initial state (docs/model.md, "What is inferred").
enum class InitialFrom : std::uint8_t { description, initial_column, rest_state, sequence, row_order, naming };

/// The I/O model <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable> of a device, or of one of its facets.
struct Unit {
  std::string_view path;    ///< LINE_PROC_DEV as its first row writes it; `DEVICE.FACET` if the facet has a name
  std::string_view device;  ///< the device level
  const pairing::Facet* facet = nullptr;  ///< in PlantModel::pairing; null if each device is one unit
  std::vector<std::uint32_t> operations;  ///< I: symbols, in list order
  std::vector<std::uint32_t> events;      ///< O: symbols, in list order
  std::vector<State> states;              ///< S
  std::vector<Transition> transitions;    ///< d_ext and d_int, in their order
  tables::Actuation actuation = tables::Actuation::latched;
  std::uint32_t rest = kNone;  ///< given or inferred; a `spring` returns to it
  std::uint32_t initial = 0;
  tables::Time travel = tables::kSecond;             ///< the default travel time
  tables::Time overrun = tables::kNever;             ///< of a `held` unit; kNever: not examined
  std::vector<condition::Tree> conditions;           ///< of transitions (when, during), then the behavior's inputs
  std::uint32_t first_input = 0;                     ///< index of the behavior's first input in `conditions`
  std::vector<std::string_view> input_names;         ///< of the behavior's inputs, sorted by bytes
  std::vector<Outputs> outputs;                      ///< one for each state; empty if no state has any
  std::vector<std::vector<std::uint32_t>> disables;  ///< for each state: units, ascending; empty if no state has any
  std::vector<std::uint32_t> reports;  ///< events that nothing links: they name no state unless the description does
  std::vector<std::uint32_t> values;   ///< numeric symbols of its device, in list order; a behavior sees them
  /// The description of its device, by name and by patterns; null without one. Points into PlantModel::description or
  /// PlantModel::joined.
  const description::DeviceDescription* described = nullptr;
  /// Indexes in `described->transitions` of those with a name that the device, or the plant, lacks, ascending.
  std::vector<std::uint32_t> left_out;

  // Decisions of the derivation, for reports to the user.
  InitialFrom initial_from = InitialFrom::sequence;
  bool rest_added = false;       ///< inference 1: NOT_X
  bool single_solenoid = false;  ///< inference 2

  /// The first symbol in list order.
  std::uint32_t first_symbol() const {
    const auto front = [](const std::vector<std::uint32_t>& symbols) {
      return symbols.empty() ? kNone : symbols.front();
    };
    return std::min({front(operations), front(events), front(values)});
  }
  bool is_report(std::uint32_t symbol) const { return std::binary_search(reports.begin(), reports.end(), symbol); }
  /// The path of its device.
  std::string_view device_path() const { return facet == nullptr ? path : facet->path; }
  /// Whether an archetype of the naming rule gives its whole model.
  bool is_archetype() const { return facet != nullptr && facet->by == pairing::FacetBy::archetype; }
  /// Whether digits at the end of its states are sequence numbers.
  bool has_sequence() const { return facet == nullptr || facet->numbered; }
  /// Whether its symbols name no state: it has only the state that every unit has.
  bool names_no_state() const {
    return states.size() == 1 && states.front().operation == kNone && states.front().event == kNone;
  }
  bool has_behaviour() const { return described != nullptr && !described->behaviour.empty(); }
  /// The numeric symbols that custom code sees.
  std::span<const std::uint32_t> behaviour_values() const {
    return has_behaviour() ? std::span<const std::uint32_t>(values) : std::span<const std::uint32_t>();
  }
  bool moves() const { return !transitions.empty() || actuation == tables::Actuation::spring || has_behaviour(); }
  /// Whether the unit can reach a state: by a transition, by the return of a spring, or by custom code.
  bool reaches(std::uint32_t state) const;
  /// Whether the unit drives the event at an index of `events`: as the event of a state, by outputs, or by custom code.
  /// O((states + outputs) * transitions).
  bool moves_event(std::uint32_t event) const;
};

/// The radix of X and Y, and what decided it.
struct RadixChoice {
  address::Radix radix = address::Radix::hexadecimal;
  enum class By : std::uint8_t { nothing, option, rows } by = By::nothing;
  const read::ListRow* proof = nullptr;       ///< a row that proves it: two addresses, or a digit that is not octal
  const read::ListRow* matters_in = nullptr;  ///< the first row in which it makes a difference; null if there is none
};

/// One symbol list of the plant.
struct PlantList {
  std::shared_ptr<const read::SymbolTable> table;  ///< holds the rows that the model points to
  std::uint32_t controller = 0;                    ///< index in PlantModel::controllers
  RadixChoice radix;                               ///< the effective one, equal for all lists of a controller
  RadixChoice own;                                 ///< from the rows and the option of this list
  std::size_t compared = 0;                        ///< the number of rows with two comparable addresses

  std::string prefix;  ///< of the names of its symbols and the lines of its devices

  std::string name() const;  ///< the name of the file without its folders
  /// How its addresses are read.
  address::Dialect dialect() const { return {table->notation, radix.radix, &table->io_words}; }
};

struct PlantModel {
  std::string name;
  std::shared_ptr<const description::Description> description;  ///< never null
  /// The files of the description; null without one.
  std::shared_ptr<const description::PlantSource> description_source;
  std::vector<std::shared_ptr<const description::DeviceDescription>> joined;  ///< of devices that several entries match
  std::vector<PlantList> lists;          ///< in the description's order; at least one
  std::vector<std::string> controllers;  ///< in the order of their first list; the default one has the name ""
  std::shared_ptr<const name::SymbolReader> reader;  ///< of the naming rule; holds the texts of names; never null
  std::shared_ptr<const pairing::Pairing> pairing;   ///< the facets of the units; null if each device is one unit
  std::shared_ptr<std::vector<name::DeviceLevels>> facet_levels;  ///< by facet; null with `pairing`
  std::shared_ptr<std::vector<name::DeviceLevels>>
      described_levels;                   ///< of devices that the description makes; or null
  std::vector<std::string> naming_files;  ///< naming.json and its links; none with a profile
  std::vector<Symbol> symbols;            ///< I/O symbols, in the order of lists and in list order
  std::vector<Unit> units;                ///< in the order of their first symbol
  std::vector<Requirement> requirements;
  std::vector<Follow> follows;                    ///< sorted by symbol
  std::vector<condition::Formula> time_formulas;  ///< of times in seconds: description::Duration::a is an index
  std::vector<Value> values;    ///< as in the description, those of `for` in the order of their devices
  std::vector<Signal> signals;  ///< sorted by symbol
  Material material;
  std::vector<Malfunction> malfunctions;  ///< as in the description
  std::vector<Alarm> alarms;
  std::vector<ControllerLink> links;  ///< by controller: the settings of its link, given or default
  std::array<std::size_t, kInternalReasons> internal{};

  const name::Naming& naming() const { return reader->naming().naming(); }
  /// The levels that the naming rule gives names; null unless it consists of one exact rule.
  const name::LevelRule* levels() const { return reader->naming().levels(); }
  /// For messages: the levels of names, or the name of the rule.
  std::string_view rule_text() const;
  /// Whether the naming rule links a symbol with others of its unit; true if the rule makes no facets.
  bool is_linked(std::uint32_t symbol) const {
    return pairing == nullptr || symbols[symbol].described || pairing->accounts[symbol] == Account::modelled;
  }
  const PlantList& list_of(const Symbol& symbol) const { return lists[symbol.list]; }
  /// The index in `lists` of the list with this row. O(lists): for messages.
  std::uint32_t list_of(const read::ListRow& row) const;
  std::uint32_t controller_of(const Symbol& symbol) const { return lists[symbol.list].controller; }
  std::string list_names() const;  ///< of all lists, separated by commas
  /// The files of the lists, in their order.
  std::vector<const text::SourceFile*> sources() const;
  /// All files of the plant: plant.json, if there is one, and what it includes, then the lists in their order, then
  /// those of the naming rule.
  std::vector<std::string> input_files() const;
};

/// `TANK.level`, or `BOOM[2]` for an output of a value with several. O(log values).
std::string output_name(const PlantModel& plant, std::uint32_t output);

}  // namespace symplant::model
