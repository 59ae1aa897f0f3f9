// Writes the results of a run as JUnit XML: expectations, requirements, findings, and whether its PLCs took part.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "symplant/host/plc_verdict.hpp"
#include "symplant/host/report.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// A run that has ended.
struct JUnitInput {
  const plant::Plant& plant;
  const trace::PlantNames& names;
  const scenario::Scenario* scenario;  ///< null: none
  std::span<const scenario::Outcome> outcomes;
  const Report& report;
  bool fail_on_findings = false;
  std::optional<bool> clean = {};    ///< with --rt-check: whether it found nothing
  const PlcVerdict* plcs = nullptr;  ///< null: without a link to a PLC
  std::string error;                 ///< why the exit code is 3; empty: it is not
};

/// A test case for each expectation, wait and requirement; with `fail_on_findings` one for all findings; with
/// --rt-check one for it; with a link to a PLC one for *no PLC* and one for plant time. An error is a case `run`.
std::string junit_text(const JUnitInput& input);

}  // namespace symplant::host
