// Shared parts of the tests of description rules: short forms to write one, and findings as text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {

/// Two devices of two states each, D and E, a button B, a number of E.
inline std::vector<Row> two_devices() {
  std::vector<Row> rows = bits({"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2", "L_P_D_I_P2", "L_P_E_O_A1", "L_P_E_I_A1",
                                "L_P_E_O_A2", "L_P_E_I_A2", "L_P_B_I_ON"});
  rows.push_back({"L_P_E_I_SPEED", "", "INT", "0", "%IW20"});
  rows.push_back({"L_P_E_I_LEVEL", "", "REAL", "0", "%ID40"});
  return rows;
}

inline description::DeviceDescription device(std::string path = "L_P_D") {
  description::DeviceDescription described;
  described.path = std::move(path);
  return described;
}

inline description::GivenTransition transition(std::string from, std::string to, std::string when = "") {
  description::GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  given.when = std::move(when);
  return given;
}

inline description::GivenTransition by_itself(std::string from, std::string to, std::string when = "") {
  description::GivenTransition given = transition(std::move(from), std::move(to), std::move(when));
  given.automatic = true;
  return given;
}

inline description::Description describing(std::vector<description::DeviceDescription> devices) {
  description::Description description;
  description.devices = std::move(devices);
  return description;
}

/// The findings of a rule: "pointer: message", one per line, followed by related locations in brackets.
inline std::string reported(const Analysed& analysed, std::string_view slug) {
  CHECK(analysed.evidence().faults.empty());
  std::string text;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    if (finding.rule->slug != slug) continue;
    text += (text.empty() ? "" : "\n") + finding.location.pointer + ": " + finding.message;
    for (const diag::Related& related : finding.related) {
      text += " [" + related.location.pointer + ": " + related.message + "]";
    }
  }
  return text;
}

}  // namespace symplant::test
