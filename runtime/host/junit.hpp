// Expectations and requirements as JUnit XML, for build servers.
#pragma once

#include <span>
#include <string>

#include "symplant/host/report.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::host {

/// One test case for each step that expects something, in order; one for each requirement; with `fail_on_findings` one
/// for all findings. Times are those of the plant.
std::string junit_text(const plant::Plant& plant, const trace::PlantNames& names, const scenario::Scenario* scenario,
                       std::span<const scenario::Outcome> outcomes, const Report& report, bool fail_on_findings);

/// A text as XML takes it between quotes or tags. What XML cannot hold (control characters, bytes that are no UTF-8)
/// stands as U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace symplant::host
