// The texts of run-time findings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/finding.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// The name in the table of docs/model.md: `lost command`.
std::string_view finding_name(tables::FindingKind kind);

/// One finding; a loop with all its units.
struct FoundThing {
  tables::Time time;
  tables::FindingKind kind;
  std::vector<std::uint32_t> of;  ///< a loop's members; else one unit, symbol, requirement, transfer or link
  std::uint64_t parts = 0;        ///< of `part blocked`: as Record::value
};

bool is_of_unit(tables::FindingKind kind);
bool is_of_symbol(tables::FindingKind kind);
/// Of a link, or of the process that runs the plant.
bool is_of_host(tables::FindingKind kind);
bool is_of_link(tables::FindingKind kind);

/// The name of its unit, symbol, requirement or link; for a loop the sorted names of its units, with blanks between.
std::string name_of(const FoundThing& found, const PlantNames& names);

/// The units that it concerns: its own, that of its symbol, or those in the conditions of its requirement.
std::vector<std::uint32_t> units_of(const FoundThing& found, const tables::PlantTables& tables);

/// `PLC output Y0001, operation P2 of EXLINE_MB_AGV (symbols.csv:4)`.
std::string symbol_words(std::uint32_t symbol, const PlantNames& names);

/// `P1`, `P1->P2`, followed by `, stopped midway`, `, disabled` or `, frozen`.
std::string state_words(std::uint32_t unit, const PlantNames& names, const History& history);

/// `since 1.5 s`, `since the start`.
std::string since_words(tables::Time changed);

/// A unit's state, what disables it, since when, and what led to it: the operation that came on last, and those that
/// are still on. `EXLINE_MB_AGV has been in P1->P2 since 0.5 s, Y0001 (operation P2, symbols.csv:4) was on from 0.5 s
/// to 0.7 s`.
std::string unit_words(std::uint32_t unit, const PlantNames& names, const History& history);

/// The parts at a location: `FIXTURE has part 11 (raw) since 3.2 s`.
/// "malfunction `clamp 1 sluggish` is active since 2 s", for each active one.
std::vector<std::string> malfunction_words(const PlantNames& names, const History& history);
std::string location_words(std::uint32_t location, const PlantNames& names, const History& history);

/// What happened, which operations led to it, what to check. For a violated requirement one more part for each unit in
/// its conditions, the latest change first. Never empty; joined by `; ` the parts are one sentence, without the time.
std::vector<std::string> finding_parts(const FoundThing& found, const PlantNames& names, const History& history);

/// Plant time in seconds: `1.5 s`.
std::string seconds(tables::Time time);

}  // namespace symplant::trace
