// What the user says of a plant beyond its symbols' names: the plant description as a value, patterns resolved.
//
// All names are texts as the user wrote them; build_plant looks them up without regard to the case of ASCII letters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/links.hpp"
#include "symplant/core/tables.hpp"
#include "symplant/core/time.hpp"

namespace symplant::model {

/// A fixed time, or one drawn anew each time.
struct Duration {
  enum class Kind : std::uint8_t { fixed, uniform, normal };
  Kind kind = Kind::fixed;
  core::Time a = 0;  ///< the time; the minimum; the mean: ns, >= 0
  core::Time b = 0;  ///< without meaning; the maximum, >= a; the standard deviation, >= 0

  static Duration fixed(core::Time time) { return {Kind::fixed, time, 0}; }
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
  std::vector<std::string> devices;  ///< exact paths
};

struct DeviceDescription {
  std::string path;  ///< LINE_PROC_DEV
  std::vector<std::string> states;
  std::optional<std::string> initial;
  std::optional<std::string> rest;
  std::optional<core::Actuation> actuation;
  bool only = false;
  std::vector<GivenTransition> transitions;
  std::vector<GivenOutputs> outputs;
  std::vector<GivenDisables> disables;
  std::string type;                                         ///< the generated class's name; empty: by the device level
  std::string behaviour;                                    ///< the user's class; empty: none
  std::vector<std::pair<std::string, std::string>> inputs;  ///< name and condition
};

/// `never` a condition, or `after` one `expect` another `within` a time: either `never` or the other two are given.
struct GivenRequirement {
  std::string name;
  std::string never;
  std::string after;
  std::string expect;
  core::Time within = 0;
};

struct Defaults {
  core::Time travel = core::kSecond;
  core::Time dwell = core::kSecond;
  core::Actuation actuation = core::Actuation::latched;
};

struct Description {
  Defaults defaults;
  std::vector<DeviceDescription> devices;
  std::vector<GivenRequirement> requirements;
  std::vector<LinkDescription> links;
};

/// What is wrong with a description: where, as a JSON pointer into plant.json ("/devices/L_P_D/transitions/2/from"),
/// and in words. `column` is the place within a condition's text, in bytes from 0; 0 elsewhere.
struct DescriptionFault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;
};

}  // namespace symplant::model
