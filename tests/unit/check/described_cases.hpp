// The descriptions of the goldens whose rule is about one.
#pragma once

#include <map>
#include <string>

#include "model/description.hpp"

namespace symplant::test {

inline model::GivenTransition way_to(std::string from, std::string to, std::string when = "") {
  model::GivenTransition way;
  way.from = std::move(from);
  way.to = std::move(to);
  way.when = std::move(when);
  return way;
}

inline model::GivenTransition at_once(std::string from, std::string to) {
  model::GivenTransition way = way_to(std::move(from), std::move(to));
  way.automatic = true;
  return way;
}

inline model::Description one_condition(std::string when) {
  model::DeviceDescription machine;
  machine.path = "EXLINE_MB_MC";
  machine.transitions = {way_to("IDLE1", "RUN2", std::move(when))};
  model::Description description;
  description.devices = {machine};
  return description;
}

inline model::Description disables_in_a_circle() {
  model::DeviceDescription agv;
  agv.path = "EXLINE_MB_AGV";
  agv.disables = {{"P2", {"EXLINE_MB_MC"}}};
  model::DeviceDescription machine;
  machine.path = "EXLINE_MB_MC";
  machine.disables = {{"RUN2", {"EXLINE_MB_AGV"}}};
  model::Description description;
  description.devices = {agv, machine};
  return description;
}

/// Two parts that both look at thirteen buttons: 2^13 combinations.
inline std::string wide_condition() {
  std::string up;
  std::string down;
  for (int i = 1; i <= 13; ++i) {
    const std::string button = "EXLINE_MB_PANEL_I_B" + std::to_string(i);
    up += (i == 1 ? "" : " and ") + button;
    down += (i == 1 ? "not " : " and not ") + button;
  }
  return up + " or " + down;
}

/// By slug.
inline std::map<std::string, model::Description> described_cases() {
  std::map<std::string, model::Description> cases;
  model::DeviceDescription machine;
  machine.path = "EXLINE_MB_MC";
  machine.states = {"FAULT"};
  cases["unreachable-state"].devices = {machine};

  machine.states.clear();
  machine.only = true;
  machine.transitions = {way_to("IDLE1", "RUN2")};
  cases["state-never-left"].devices = {machine};

  machine.only = false;
  machine.transitions = {at_once("IDLE1", "RUN2"), at_once("RUN2", "IDLE1")};
  cases["zero-time-loop"].devices = {machine};

  cases["cycle-of-disables"] = disables_in_a_circle();
  cases["condition-never-holds"] = one_condition("EXLINE_MB_AGV.P1 and EXLINE_MB_AGV.P2");
  cases["condition-always-holds"] = one_condition("not EXLINE_MB_AGV.P1 or not EXLINE_MB_AGV.P2");
  cases["condition-not-examined"] = one_condition(wide_condition());
  cases["requirement-decided"].requirements = {
      {"no machining without part", "EXLINE_MB_MC.RUN2 and EXLINE_MB_MC.moving", "", "", 0},
      {"answers", "", "EXLINE_MB_AGV.P2", "EXLINE_MB_MC.IDLE1 and EXLINE_MB_MC.RUN2", core::kSecond}};
  return cases;
}

}  // namespace symplant::test
