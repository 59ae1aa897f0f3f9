// What the user says of a plant beyond its symbols' names: the plant description as a value.
//
// All names are texts as the user wrote them; build_plant looks them up without regard to the case of ASCII letters.
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

#include "description/links.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::description {

/// As plant.json has it: `latched`, `bistable`, `held`, `spring`.
std::string_view actuation_name(tables::Actuation actuation);

/// A fixed time, or one drawn anew each time.
struct Duration {
  enum class Kind : std::uint8_t { fixed, uniform, normal };
  Kind kind = Kind::fixed;
  tables::Time a = 0;  ///< the time; the minimum; the mean: ns, >= 0
  tables::Time b = 0;  ///< without meaning; the maximum, >= a; the standard deviation, >= 0

  static Duration fixed(tables::Time time) { return {Kind::fixed, time, 0}; }
  bool is_zero() const { return kind == Kind::fixed && a == 0; }
  friend bool operator==(const Duration&, const Duration&) = default;
};

struct GivenTransition {
  std::string from;  ///< a state, or "*": every one other than `to`
  std::string to;
  std::string on;    ///< the task of an operation; empty: `to`'s own, unless `automatic`
  std::string when;  ///< a condition; empty: none
  bool automatic = false;
  bool once = false;
  std::optional<Duration> after;
  std::optional<Duration> takes;
};

/// l_enter and l_leave of a state beyond its own event: further own events, by task, in this order.
struct GivenOutputs {
  std::string state;
  std::vector<std::pair<std::string, bool>> enter;
  std::vector<std::pair<std::string, bool>> leave;
};

struct GivenDisables {
  std::string state;
  std::vector<std::string> devices;  ///< names, or patterns
};

/// What may be said of a device, key by key.
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
};
inline constexpr std::size_t kDeviceKeys = 11;
/// As plant.json has it.
std::string_view device_key_name(DeviceKey key);

/// What is said of a device, or of all whose path matches a pattern. build_plant joins all that is said of one device
/// to one of these, key by key (describe.hpp).
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
  std::string type;                                         ///< the generated class's name; empty: by the device level
  std::string behaviour;                                    ///< the user's class; empty: none
  std::vector<std::pair<std::string, std::string>> inputs;  ///< name and condition

  /// Keys that are given though they hold no more than the default (`"only": false`, an empty array).
  std::bitset<kDeviceKeys> given;
  /// Of a pattern: each key's value as JSON text, by DeviceKey. Two patterns that are equally specific must agree in
  /// it.
  std::vector<std::string> texts;
  /// Of one that was joined: which entry of the description each key is of; null: this very one.
  std::array<const DeviceDescription*, kDeviceKeys> from{};

  bool is_pattern() const { return path.find_first_of("*?") != std::string::npos; }
  bool gives(DeviceKey key) const;
  /// Takes a key over from another entry, which must outlive this one.
  void take(DeviceKey key, const DeviceDescription& other);
  /// The entry that a key is of.
  const DeviceDescription& entry_of(DeviceKey key) const {
    const DeviceDescription* entry = from[static_cast<std::size_t>(key)];
    return entry == nullptr ? *this : *entry;
  }
};

/// `never` a condition, or `after` one `expect` another `within` a time: either `never` or the other two are given.
struct GivenRequirement {
  std::string name;
  std::string never;
  std::string after;
  std::string expect;
  tables::Time within = 0;
};

struct Defaults {
  tables::Time travel = tables::kSecond;
  tables::Time dwell = tables::kSecond;
  tables::Actuation actuation = tables::Actuation::latched;
};

/// What `symplant check` is told, as texts: rules by id or slug.
struct GivenCheck {
  struct Ignore {
    std::string rule;
    std::string symbols;  ///< a pattern; empty: all
    std::string why;
    std::string until;  ///< a date; empty: for ever
  };
  std::vector<Ignore> ignore;
  std::vector<std::pair<std::string, std::string>> severity;  ///< rule, severity
};

struct Description {
  Defaults defaults;
  std::vector<DeviceDescription> devices;
  std::vector<GivenRequirement> requirements;
  std::vector<LinkDescription> links;
  GivenCheck check;
};

/// What kind of fault it is; each has a rule (description_rules.hpp).
enum class FaultKind : std::uint8_t {
  contradiction,    ///< what is said cannot be, or contradicts itself or the list
  shape,            ///< it does not fit the format
  unknown_name,     ///< there is no device, state, operation, event or symbol of that name
  patterns,         ///< two equally specific patterns disagree
  matches_nothing,  ///< a pattern fits no device: a warning
  left_out,         ///< some devices that a pattern fits lack what it names: a warning
  condition,        ///< a text is no condition of this plant
};

/// What is wrong with a description: where, as a JSON pointer into plant.json ("/devices/L_P_D/transitions/2/from"),
/// and in words. `column` is the place within a condition's text, in bytes from 0; 0 elsewhere.
struct DescriptionFault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;
  FaultKind kind = FaultKind::contradiction;
  bool at_key = false;       ///< the value's key is at fault
  std::string related = {};  ///< a second place, as a pointer; empty: none
  std::string related_message = {};
};

}  // namespace symplant::description
