// The plant as derived from symbol lists: symbols, units and their I/O models. Nobody changes it once it is built.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "address/address.hpp"
#include "description/description.hpp"
#include "model/controller_link.hpp"
#include "name/name_parser.hpp"
#include "read/symbol_table.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::model {

inline constexpr std::uint32_t kNone = 0xFFFF'FFFF;

/// Why a row of the list is no I/O symbol. Such rows are counted and served nowhere.
enum class InternalReason : std::uint8_t {
  constant,      ///< VAR_CONSTANT and the like
  memory,        ///< an address in the PLC's memory: M, D, %M
  type,          ///< TIME, STRING, an array, a structure, a function block
  no_direction,  ///< no address, and a name that tells no direction
};
inline constexpr std::size_t kInternalReasons = 4;
std::string_view internal_reason_text(InternalReason reason);

/// Why an I/O symbol is in no unit. It is served all the same: in the images, on the links, in traces.
enum class Unmodelled : std::uint8_t {
  modelled,        ///< it is in one
  numeric,         ///< states come from BOOL symbols only
  name,            ///< its name does not follow the rule
  task_taken,      ///< another symbol of its unit has its task and direction
  unit_too_large,  ///< its unit has more symbols or states than a unit may have
};

/// One I/O symbol. Views point into its list.
struct Symbol {
  const read::ListRow* row = nullptr;
  name::NameReading reading;
  tables::Direction direction{};
  tables::DataType type{};
  std::optional<address::Address> address;
  std::string_view address_cell;  ///< the cell that it was read from; empty without one
  bool initial_known = true;      ///< false: its Initial could not be read
  std::uint64_t initial = 0;      ///< as tables::InitialValue has it; 0 where the list says nothing
  std::uint32_t list = 0;         ///< whose row it is: a place in PlantModel::lists
  Unmodelled unmodelled = Unmodelled::modelled;
  std::uint32_t unit = kNone;
  std::uint32_t leader = kNone;  ///< the symbol whose value it follows, on one address; kNone where it leads itself

  std::string_view name() const { return row->name; }
  /// As the list writes it: the vendor's, or else the IEC one; empty where there is none.
  std::string_view written_address() const {
    return row->vendor_address.empty() ? row->iec_address : row->vendor_address;
  }
};

/// A task of a unit. Operations and events are places in Unit::operations and Unit::events.
struct State {
  std::string name;
  std::uint32_t operation = kNone;
  std::uint32_t event = kNone;
  bool numbered = false;  ///< its name ends in a sequence number
};

/// Where a transition comes from; says in which order they stand, too.
enum class Origin : std::uint8_t { given, derived, inferred };

/// From a state to another, by place in Unit::states.
struct Transition {
  std::uint32_t from = kNone;
  std::uint32_t to = kNone;
  std::uint32_t on = kNone;  ///< a place in Unit::operations; kNone where it is automatic or a spring's own way
  description::Duration after;
  description::Duration takes;
  Origin origin = Origin::derived;
  bool spring_return = false;  ///< only says how long a spring's own way takes
  bool once = false;
  std::uint32_t when = kNone;   ///< a place in Unit::conditions
  std::uint32_t given = kNone;  ///< a place in DeviceDescription::transitions
};

/// Events that l_enter or l_leave switches beyond the state's own, by place in Unit::events, in this order.
struct Outputs {
  std::vector<std::pair<std::uint32_t, bool>> enter;
  std::vector<std::pair<std::uint32_t, bool>> leave;
};

/// A requirement, its conditions resolved: `never`, or `after` and `expect`.
struct Requirement {
  std::string name;
  tables::RequirementRow::Kind kind = tables::RequirementRow::Kind::never;
  condition::Tree condition;  ///< of `never`, or of `after`
  condition::Tree expected;   ///< of `expect`
  tables::Time within = 0;
};

/// What was inferred for a unit, and why: the rules of docs/model.md, "What is inferred".
enum class InitialFrom : std::uint8_t { description, initial_column, rest_state, sequence, row_order };

/// One device's I/O model <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable>.
struct Unit {
  std::string_view path;                  ///< LINE_PROC_DEV as the first of its rows writes it
  std::string_view device;                ///< the device level
  std::vector<std::uint32_t> operations;  ///< I: symbols, in list order
  std::vector<std::uint32_t> events;      ///< O: symbols, in list order
  std::vector<State> states;              ///< S
  std::vector<Transition> transitions;    ///< d_ext and d_int, in their order
  tables::Actuation actuation = tables::Actuation::latched;
  std::uint32_t rest = kNone;  ///< given or inferred; a `spring` returns to it
  std::uint32_t initial = 0;
  tables::Time travel = tables::kSecond;    ///< the default travel time
  std::vector<condition::Tree> conditions;  ///< what transitions want, by Transition::when, then the behaviour's inputs
  std::uint32_t first_input = 0;            ///< of the behaviour's inputs, in `conditions`
  std::vector<std::string_view> input_names;  ///< of the behaviour's inputs, sorted by bytes
  std::vector<Outputs> outputs;               ///< a state each, or empty where no state has any
  std::vector<std::vector<std::uint32_t>>
      disables;                       ///< a state each: units, ascending; or empty where no state has any
  std::vector<std::uint32_t> values;  ///< its device's numeric symbols, where it has a behaviour
  /// What the user says of its device, by name and by patterns; null where nothing. Points into PlantModel::description
  /// or PlantModel::joined.
  const description::DeviceDescription* described = nullptr;
  std::vector<std::uint32_t>
      left_out;  ///< places in `described->transitions` that name what the device lacks, ascending

  // What the derivation decided, for whoever tells the user.
  InitialFrom initial_from = InitialFrom::sequence;
  bool rest_added = false;                        ///< inference 1: NOT_X
  bool single_solenoid = false;                   ///< inference 2
  bool two_words = false;                         ///< X has only an operation, Y only an event: perhaps one state
  std::uint32_t initial_candidates = 0;           ///< states whose event alone has Initial TRUE
  std::vector<std::uint32_t> ambiguous_sequence;  ///< states whose predecessor's number several states have

  bool has_behaviour() const { return described != nullptr && !described->behaviour.empty(); }
  bool moves() const { return !transitions.empty() || actuation == tables::Actuation::spring || has_behaviour(); }
  /// Whether the unit can come into a state, by a transition, as a spring's rest, or by the user's code.
  bool reaches(std::uint32_t state) const;
  /// Whether the unit ever changes the event at a place of `events`: as that of a state, by outputs, or by the user's
  /// code. O(states and outputs, times transitions).
  bool moves_event(std::uint32_t event) const;
};

/// Two rows of one name. The first counts.
struct Duplicate {
  const read::ListRow* first;
  const read::ListRow* second;
  bool same;  ///< address and type agree: harmless
};

/// A unit with more symbols or states than a unit may have; its symbols stay unmodelled.
struct TooLarge {
  std::string_view path;
  std::vector<std::uint32_t> symbols;
  std::size_t operations;
  std::size_t events;
  std::size_t states;
};

/// How X and Y are counted, and what says so.
struct RadixChoice {
  address::Radix radix = address::Radix::hexadecimal;
  enum class By : std::uint8_t { nothing, option, rows } by = By::nothing;
  const read::ListRow* proof = nullptr;       ///< a row whose two addresses, or a digit that octal has not, prove it
  const read::ListRow* matters_in = nullptr;  ///< the first row in which it makes a difference; null where in none
};

/// One symbol list of the plant.
struct PlantList {
  std::shared_ptr<const read::SymbolTable> table;  ///< rows that the model points to
  std::uint32_t controller = 0;                    ///< a place in PlantModel::controllers
  RadixChoice radix;                               ///< what counts: one for all lists of a controller
  RadixChoice own;                                 ///< what its own rows and its own option say
  std::size_t compared = 0;                        ///< rows with two addresses that can be held against each other

  std::string name() const;  ///< the file's name without its folders
};

/// A row with an address of the PLC's inputs or outputs whose type is none of an I/O symbol's.
struct TypelessIo {
  const read::ListRow* row;
  std::string_view address_cell;
};

/// A row of an I/O symbol, or of what one of its addresses says is one, whose two addresses name different places. The
/// IEC one counts.
struct AddressContradiction {
  const read::ListRow* row = nullptr;
  std::uint32_t list = 0;
  address::Address vendor;
  address::Address iec;
};

/// An address cell that is no address.
struct BadAddress {
  const read::ListRow* row;
  std::string_view cell;
};

struct PlantModel {
  std::string name;
  std::shared_ptr<const description::Description> description;  ///< never null
  /// The file that it was read from; null where there is none.
  std::shared_ptr<const text::SourceFile> description_source;
  std::vector<std::shared_ptr<const description::DeviceDescription>>
      joined;                            ///< of devices that several entries speak of
  std::vector<PlantList> lists;          ///< in the description's order; at least one
  std::vector<std::string> controllers;  ///< in the order of their first list; the default one has the name ""
  const name::NamingRule* rule = nullptr;
  std::vector<Symbol> symbols;  ///< I/O symbols, in the order of lists and in list order
  std::vector<Unit> units;      ///< in the order of their first symbol
  std::vector<Requirement> requirements;
  std::vector<ControllerLink> links;  ///< by controller: how it is linked, whether a link is given or not
  std::vector<description::DescriptionFault>
      description_faults;  ///< while there is one, nothing is to be made of the plant
  std::vector<description::DescriptionFault> description_warnings;
  std::vector<std::string> description_decisions;  ///< which pattern speaks of how many devices, for --verbose
  std::array<std::size_t, kInternalReasons> internal{};
  std::vector<Duplicate> duplicates;
  std::vector<TooLarge> too_large;
  std::vector<BadAddress> bad_addresses;
  std::vector<AddressContradiction> address_contradictions;  ///< in list order
  std::vector<TypelessIo> typeless_io;
  /// Pairs of events that different moving units put on one address: second, first; by the second.
  std::vector<std::array<std::uint32_t, 2>> driven_twice;

  const PlantList& list_of(const Symbol& symbol) const { return lists[symbol.list]; }
  /// The list that a row stands in, a place in `lists`. O(lists): for messages.
  std::uint32_t list_of(const read::ListRow& row) const;
  std::uint32_t controller_of(const Symbol& symbol) const { return lists[symbol.list].controller; }
  std::string list_names() const;  ///< of all lists, with commas between
  /// The files of the lists, in their order.
  std::vector<const text::SourceFile*> sources() const;
  /// Every file that it was read from: plant.json, where there is one, then the lists in their order.
  std::vector<std::string> input_files() const;
};

}  // namespace symplant::model
