// Shared parts of the tests of descriptions: short forms to write one, and its faults as text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model_support.hpp"

namespace symplant::test {

using description::DeviceDescription;
using description::Duration;
using description::GivenTransition;

inline DeviceDescription device(std::string path = "L_P_D") {
  DeviceDescription described;
  described.path = std::move(path);
  return described;
}

/// A commanded transition; without `on`, by the target's own operation.
inline GivenTransition transition(std::string from, std::string to, std::string on = "", std::string when = "") {
  GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  given.on = std::move(on);
  given.when = std::move(when);
  return given;
}

inline GivenTransition automatic(std::string from, std::string to, std::string when = "") {
  GivenTransition given = transition(std::move(from), std::move(to), "", std::move(when));
  given.automatic = true;
  return given;
}

inline GivenTransition taking(GivenTransition given, tables::Time takes) {
  given.takes = Duration::fixed(takes);
  return given;
}

inline description::Description describing(std::vector<DeviceDescription> devices) {
  description::Description description;
  description.devices = std::move(devices);
  return description;
}

/// A list of these BOOL symbols (support/compile.hpp: bits) with a description of devices.
inline Analysed described(const std::vector<std::string>& names, std::vector<DeviceDescription> devices) {
  return analyse_described(bits(names), describing(std::move(devices)));
}

/// All faults: "pointer: message", one per line.
inline std::string faults(const Analysed& analysed) {
  std::string text;
  for (const description::DescriptionFault& fault : analysed.evidence().faults) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

inline std::string origins(const model::Unit& unit) {
  std::string text;
  for (const model::Transition& t : unit.transitions) {
    text += t.origin == model::Origin::given ? 'g' : t.origin == model::Origin::derived ? 'd' : 'i';
  }
  return text;
}

}  // namespace symplant::test
