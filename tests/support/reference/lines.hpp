// The output of a run, line by line, as docs/plant-description.md defines it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/reference/reference.hpp"

namespace symplant::reference {

/// As the table in docs/model.md names it: `lost command`.
std::string_view finding_name(tables::FindingKind kind);

/// The name of a malfunction of the description, or of an ordinary one.
std::string malfunction_name(const model::PlantModel& model, std::uint32_t number);

/// The lines of a trace after its header.
std::vector<std::string> trace_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants);

/// The defined part of each finding's line: `{"t":5,"finding":"lost command","of":"L_P_D_O_UP"`. The units of a loop
/// are in one line.
std::vector<std::string> finding_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants);

}  // namespace symplant::reference
