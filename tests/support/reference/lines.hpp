// What a run writes down, line by line, as docs/plant-description.md tells it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/reference/reference.hpp"

namespace symplant::reference {

/// As the page's table has it: `lost command`.
std::string_view finding_name(tables::FindingKind kind);

/// The lines of a trace behind its header.
std::vector<std::string> trace_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants);

/// Of each finding's line the part that the page fixes: `{"t":5,"finding":"lost command","of":"L_P_D_O_UP"`. A loop's
/// units stand in one line.
std::vector<std::string> finding_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants);

}  // namespace symplant::reference
