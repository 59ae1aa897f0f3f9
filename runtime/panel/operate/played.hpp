// The scenario that plays, for the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "symplant/panel/role.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// What a step does or expects: "wait: `AGV.P2` within 5 s", or "force L_P_AGV_I_P2 off".
std::string step_words(const scenario::Scenario& scenario, std::size_t step, const trace::PlantNames& names);

/// The progress of the scenario that plays.
class Played {
 public:
  Played(const trace::PlantNames& names, std::string name) : names_(names), name_(std::move(name)) {}

  /// Null: none is played.
  void begin(const scenario::Scenario* scenario);
  void step_done(std::size_t step);
  void over();
  /// Forgets the progress: it is unknown until the next step.
  void forget();

  /// Appends the object, or null. Only a trainer sees what comes next.
  void put(std::string& json, Role role) const;
  /// A different number after each change.
  std::uint64_t version() const { return version_; }

 private:
  /// What the scenario does next; empty if that is unknown.
  std::string next() const;

  const trace::PlantNames& names_;
  std::string name_;
  const scenario::Scenario* scenario_ = nullptr;
  std::size_t done_ = 0;  ///< the number of the step that was done last, from 1; 0: none
  bool known_ = true;
  bool over_ = false;
  std::uint64_t version_ = 1;
};

}  // namespace symplant::panel
