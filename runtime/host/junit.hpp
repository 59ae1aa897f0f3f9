// Reports expectations and requirements as JUnit XML, for build servers.
#pragma once

#include <span>
#include <string>

#include "symplant/host/report.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::host {

/// One test case for each step with an expectation, in order; one for each requirement; one for all findings if
/// `fail_on_findings`. Times are plant times.
std::string junit_text(const plant::Plant& plant, const trace::PlantNames& names, const scenario::Scenario* scenario,
                       std::span<const scenario::Outcome> outcomes, const Report& report, bool fail_on_findings);

}  // namespace symplant::host
