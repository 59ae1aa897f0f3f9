// The texts of run-time findings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/finding.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::trace {

/// The name in the table of docs/model.md: `lost command`.
std::string_view finding_name(tables::FindingKind kind);

/// One finding; a loop with all its units.
struct FoundThing {
  tables::Time time;
  tables::FindingKind kind;
  std::vector<std::uint32_t> of;  ///< members of a loop, at least one; else one unit, symbol, requirement, ...
  std::uint64_t value = 0;        ///< as Record::value, for the kinds that have one
};

bool is_of_unit(tables::FindingKind kind);
bool is_of_symbol(tables::FindingKind kind);
/// Whether a finding of this kind is of a link, or of the process that runs the plant.
bool is_of_host(tables::FindingKind kind);
bool is_of_link(tables::FindingKind kind);

/// The name of its unit, symbol, requirement or link; for a loop the sorted names of its members, separated by blanks,
/// or by ", " if they are malfunctions.
std::string name_of(const FoundThing& found, const PlantNames& names);

/// Whether it is an instantaneous loop of malfunctions.
bool is_of_malfunctions(const FoundThing& found, const PlantNames& names);

/// The units that it concerns: its own, that of its symbol, or those in the conditions of its requirement.
std::vector<std::uint32_t> units_of(const FoundThing& found, const tables::PlantTables& tables);

/// `PLC output Y0001, operation P2 of EXLINE_MB_AGV (symbols.csv:4)`; of an inverted symbol `PLC output Y0001
/// (inverted), operation ...`.
std::string symbol_words(std::uint32_t symbol, const PlantNames& names);

/// `P1`, `P1->P2`, followed by `, stopped midway`, `, disabled` or `, frozen`.
std::string state_words(std::uint32_t unit, const PlantNames& names, const plant::UnitView& view);

/// What happened, which operations led to it, what to check: one sentence, without the time. Not for a violated
/// requirement, which why::Explainer explains.
std::string finding_words(const FoundThing& found, const PlantNames& names, const History& history);
/// "requirement violated: `NAME`, its condition must never hold and now holds". `early`: what is expected holds, but
/// too early.
std::string requirement_words(std::uint32_t requirement, bool early, const PlantNames& names);

}  // namespace symplant::trace
