// A rule: what is known of it, and how it looks for its fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/faults.hpp"
#include "diag/diagnostic.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

class DeviceClasses;
class OverruledNames;
struct WrittenCondition;

/// What rules look at: the plant, and what several of them need to know of it, made once.
struct Subject {
  const model::PlantModel& plant;
  const model::Evidence& evidence;
  const DeviceClasses& classes;
  const OverruledNames& overruled;
  const std::vector<WrittenCondition>& conditions;  ///< of the description
};

struct Rule {
  diag::RuleInfo info;
  /// Adds a finding for every place where the rule is broken: one root cause, one finding. Null for rules about the
  /// settings, which are no part of the plant.
  void (*check)(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) = nullptr;
};

/// Where a cell of a row stands: the cell itself, or the whole row where the cell is not in the file as it is.
diag::Location location_of(const model::PlantModel& plant, const read::ListRow& row, std::string_view cell);
/// A symbol's name.
diag::Location location_of(const model::PlantModel& plant, const model::Symbol& symbol);
/// A place in the plant description, by JSON pointer; until it is located, or where there is no file, `fallback` stands
/// for it.
diag::Location location_of(diag::Location fallback, const description::Pointer& pointer);
/// What the description says of a unit at one of its keys; the unit's first symbol stands for it. The unit must be
/// described.
diag::Location described_location(const model::PlantModel& plant, const model::Unit& unit,
                                  const description::Pointer& pointer);
/// An entry that speaks of a unit's device; its `only` where that is what takes its ways away.
description::Pointer entry_pointer(const model::Unit& unit);
description::Pointer transitions_pointer(const model::Unit& unit);
/// Where a given transition stands, or one of its keys.
description::Pointer transition_pointer(const model::Unit& unit, const model::Transition& transition,
                                        std::string_view key = {});
/// Whether the plant has a description at all.
bool has_description(const model::PlantModel& plant);
/// Whether it says something of devices or has requirements, and is without faults, so that it can be looked at.
bool is_described(const Subject& subject);
/// What the derivation noticed about a unit of the plant.
const model::UnitEvidence& evidence_of(const Subject& subject, const model::Unit& unit);
/// The symbol at a place of a unit's operations or events.
const model::Symbol& operation_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location);
const model::Symbol& event_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location);
/// The first symbol of a unit in list order.
const model::Symbol& first_symbol_of(const model::PlantModel& plant, const model::Unit& unit);
/// What a finding is about, as the user may name it in his settings: a symbol and its device, or a device.
std::vector<std::string> about(const model::Symbol& symbol);
/// Of two on one address: the other's name stands behind the symbol's.
std::vector<std::string> about(const model::Symbol& symbol, const model::Symbol& other);
std::vector<std::string> about(const model::Unit& unit);
std::vector<std::string> about(const read::ListRow& row);
/// "operation" or "event".
std::string_view direction_text(tables::Direction direction);

}  // namespace symplant::check
