// The plant description as a value: what the user states about a plant beyond the names of its symbols.
//
// All names are texts as the user wrote them; the derivation of the plant resolves them without regard to ASCII case.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/duration.hpp"
#include "elements/alarm/given.hpp"
#include "elements/follow/given.hpp"
#include "elements/link/given.hpp"
#include "elements/malfunction/given.hpp"
#include "elements/material/given.hpp"
#include "elements/requirement/given.hpp"
#include "elements/scene/given.hpp"
#include "elements/signal/given.hpp"
#include "elements/times/given.hpp"
#include "elements/value/given.hpp"
#include "symplant/tables/shape.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::description {

/// The word in plant.json: `latched`, `bistable`, `held`, `spring`.
std::string_view actuation_name(tables::Actuation actuation);

/// Which numbered states a derived d_ext may join.
enum class Sequence : std::uint8_t {
  free,        ///< all
  neighbours,  ///< those whose numbers are next to each other among the unit's numbers
  cycle,       ///< from each number to the next higher one, and from the highest to the lowest
};
/// The word in plant.json.
std::string_view sequence_name(Sequence sequence);

struct GivenTransition {
  std::string from;  ///< a state, or "*": every state except `to`
  std::string to;
  std::string on;    ///< the task of an operation; empty: that of `to`, unless `automatic`
  std::string when;  ///< a condition; empty: none
  bool automatic = false;
  bool once = false;
  std::optional<Duration> after = {};
  std::optional<Duration> takes = {};
  std::string during = {};  ///< `while`: a condition; empty: none
  tables::TransitionNumbers numbers = {};
};

/// l_enter and l_leave of a state besides its event: further events of the device, by task, in this order.
struct GivenOutputs {
  std::string state;
  std::vector<std::pair<std::string, bool>> enter;
  std::vector<std::pair<std::string, bool>> leave;
};

struct GivenDisables {
  std::string state;
  std::vector<std::string> devices;  ///< names, or patterns
};

/// The keys of a device's entry.
enum class DeviceKey : std::uint8_t {
  states,
  initial,
  rest,
  actuation,
  only,
  transitions,
  outputs,
  disables,
  type,
  behaviour,
  inputs,
  overrun,
  sequence,
};
inline constexpr std::size_t kDeviceKeys = 13;
/// The name of the key in plant.json.
std::string_view device_key_name(DeviceKey key);

/// The description of a device, or of all devices whose path matches a pattern. The derivation of the plant joins all
/// descriptions of one device into one, key by key.
struct DeviceDescription {
  std::string path;  ///< LINE_PROC_DEV, or a pattern of it with `*` and `?`
  std::vector<std::string> states;
  std::optional<std::string> initial;
  std::optional<std::string> rest;
  std::optional<tables::Actuation> actuation;
  bool only = false;
  std::vector<GivenTransition> transitions;
  std::vector<GivenOutputs> outputs;
  std::vector<GivenDisables> disables;
  std::string type;                                         ///< the generated class; empty: named by the device level
  std::string behaviour;                                    ///< the custom class; empty: not given
  std::vector<std::pair<std::string, std::string>> inputs;  ///< name and condition
  /// Symbols of the device, whatever their names, as task and symbol. Only in an entry with an exact name.
  std::vector<std::pair<std::string, std::string>> operations;
  std::vector<std::pair<std::string, std::string>> events;
  std::optional<tables::Time> overrun;  ///< kNever: not examined
  std::optional<Sequence> sequence;

  bool by_naming = false;      ///< the naming rule gives it, not plant.json
  bool covers_facets = false;  ///< it names a device with several facets, and is for all of them

  /// Keys that are given, even with the default value (`"only": false`, an empty array).
  std::bitset<kDeviceKeys> given;
  /// For a pattern: the value of each key as JSON text, by DeviceKey. Two equally specific patterns must agree in it.
  std::vector<std::string> texts;
  /// For a joined description: the entry that gives each key; null: this one.
  std::array<const DeviceDescription*, kDeviceKeys> from{};

  /// Whether it is for several units, which may lack what it names.
  bool is_pattern() const { return covers_facets || path.find_first_of("*?") != std::string::npos; }
  /// Whether it applies to a unit. A device with several units has another path than its units.
  bool matches(std::string_view unit_path, std::string_view device_path) const;
  bool gives(DeviceKey key) const;
  /// Whether it makes the device from symbols that it names.
  bool names_symbols() const { return !operations.empty() || !events.empty(); }
  /// Copies a key from another entry, which must outlive this one.
  void take(DeviceKey key, const DeviceDescription& other);
  /// The entry that gives a key.
  const DeviceDescription& entry_of(DeviceKey key) const {
    const DeviceDescription* entry = from[static_cast<std::size_t>(key)];
    return entry == nullptr ? *this : *entry;
  }
};

/// Where the panel shows a device.
struct GivenView {
  std::string device;   ///< its path
  std::int32_t x = -1;  ///< in its station, in grid units from 0; -1: the page chooses
  std::int32_t y = -1;
  std::string group = {};  ///< the frame in which it is shown, instead of its station; empty: its station
  std::optional<tables::Shape> shape = {};  ///< in the plan; nothing: guessed
};

/// Patterns of rows, by name or address, that are I/O although their address is internal or missing.
struct GivenIo {
  std::vector<std::string> events;
  std::vector<std::string> operations;
};

struct Defaults {
  tables::Time travel = tables::kSecond;
  tables::Time dwell = tables::kSecond;
  tables::Actuation actuation = tables::Actuation::latched;
  tables::Time overrun = 2 * tables::kSecond;  ///< kNever: not examined
  Sequence sequence = Sequence::free;
  tables::Time step = tables::kMillisecond * 10;  ///< of values and signals
};

/// Settings of `symplant check`, as texts: rules by id or slug.
struct GivenCheck {
  /// An entry for `symplant check` has `rule`, an entry for a run has `finding`; the other member is empty.
  struct Ignore {
    std::string rule;
    std::string symbols;  ///< a pattern of symbols, devices or requirements; empty: all
    std::string why;
    std::string until;         ///< a date; empty: without end
    std::string finding = {};  ///< `started on enabling`
  };
  /// How the names of some symbols are to look.
  struct Convention {
    std::vector<std::string> types;  ///< as lists write them, compared without regard to case; empty: all
    std::string symbols;             ///< a pattern; empty: all
    std::optional<bool> operation;   ///< only outputs, or only inputs
    std::vector<std::string> prefix;
    std::vector<std::string> suffix;
    std::string letters;      ///< upper, lower, camel or pascal; empty: any
    std::uint32_t least = 0;  ///< code points
    std::uint32_t most = 0;   ///< code points; 0: any number
  };
  std::vector<Ignore> ignore;
  std::vector<std::pair<std::string, std::string>> severity;  ///< rule, severity
  std::vector<Convention> conventions;
};

struct Description {
  Defaults defaults;
  std::vector<std::string> inverted;  ///< symbols, or patterns
  std::vector<std::string> plain;     ///< BOOL symbols of no device, or patterns
  GivenIo io;
  std::vector<DeviceDescription> devices;
  std::vector<GivenTimes> times;
  std::vector<GivenFollow> follow;
  std::vector<GivenValue> values;
  std::vector<GivenSignal> signals;
  GivenMaterial material;
  std::vector<GivenMalfunction> malfunctions;
  std::vector<GivenAlarm> alarms;
  std::vector<GivenRequirement> requirements;
  std::vector<LinkDescription> links;
  std::vector<ProgramDescription> programs;
  GivenCheck check;
  std::vector<GivenView> view;
  GivenScene scene;
};

/// The kind of a fault; each has a rule (description_rules.hpp).
enum class FaultKind : std::uint8_t {
  contradiction,    ///< the description contradicts itself or the list
  shape,            ///< the file does not fit the format
  unknown_name,     ///< device, state, operation, event or symbol not found
  patterns,         ///< two equally specific patterns disagree
  matches_nothing,  ///< a pattern matches no device: a warning
  left_out,         ///< some devices that a pattern matches lack the name: a warning
  condition,        ///< a text is not a condition of this plant
};

/// A fault of a description: a JSON pointer into plant.json ("/devices/L_P_D/transitions/2/from") and a message.
/// `column` is the offset within the text of a condition, in bytes from 0; else 0.
struct DescriptionFault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;
  FaultKind kind = FaultKind::contradiction;
  bool at_key = false;       ///< the key of the value is at fault
  std::string related = {};  ///< a second location, as a pointer; empty: none
  std::string related_message = {};
};

}  // namespace symplant::description
