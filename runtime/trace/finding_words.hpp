// Findings as a PLC programmer speaks of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/finding.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// As the table in docs/model.md has it: `lost command`.
std::string_view finding_name(tables::FindingKind kind);

/// One finding, a loop with all its units.
struct FoundThing {
  tables::Time time;
  tables::FindingKind kind;
  std::vector<std::uint32_t> of;  ///< a loop's units; else one unit, symbol, requirement or link
};

bool is_of_unit(tables::FindingKind kind);
bool is_of_symbol(tables::FindingKind kind);
bool is_of_link(tables::FindingKind kind);

/// What it is of, by name; a loop's units sorted, with blanks between.
std::string name_of(const FoundThing& found, const PlantNames& names);

/// The units that it is about: its own, its symbol's, those that its requirement looks at.
std::vector<std::uint32_t> units_of(const FoundThing& found, const tables::PlantTables& tables);

/// `PLC output Y0001, operation P2 of EXLINE_MB_AGV (symbols.csv:4)`.
std::string symbol_words(std::uint32_t symbol, const PlantNames& names);

/// `P1`, `P1->P2 (moving)`, with what stops it.
std::string state_words(std::uint32_t unit, const PlantNames& names, const History& history);

/// `since 1.5 s`, `since the start`.
std::string since_words(tables::Time changed);

/// Where a unit is, who disables it, since when, and what led it there: the operation that came on last, and those that
/// are on still. `EXLINE_MB_AGV is in P1->P2 since 0.5 s, Y0001 (operation P2, symbols.csv:4) was on from 0.5 s to 0.7
/// s`.
std::string unit_words(std::uint32_t unit, const PlantNames& names, const History& history);

/// What is there, which operations led to it, what to look at; for a violated requirement a further part for each unit
/// that it looks at, the last to change first. Never empty; joined by `; ` they are one sentence. Its time is not in
/// it.
std::vector<std::string> finding_parts(const FoundThing& found, const PlantNames& names, const History& history);

/// Plant time as people write it: `1.5 s`.
std::string seconds(tables::Time time);

}  // namespace symplant::trace
