// A rule: its description, and the function that checks it.
#pragma once

#include <cstddef>
#include <memory>
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
  const std::vector<bool>& named_otherwise;         ///< for each list: SP208 or SP415 reports all its names at once
};

struct Rule {
  diag::RuleInfo info;
  /// Adds a finding for each violation of the rule: one root cause, one finding. Null for rules about the
  /// settings, which are no part of the plant.
  void (*check)(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) = nullptr;
};

/// The location of a cell: the cell itself, or the whole row if the file has the cell in another form (escaped).
diag::Location location_of(const model::PlantModel& plant, const read::ListRow& row, std::string_view cell);
/// A symbol's name.
diag::Location location_of(const model::PlantModel& plant, const model::Symbol& symbol);
/// A location in the plant description, by JSON pointer. `fallback` is used until it is resolved, or if there is no
/// file.
diag::Location location_of(diag::Location fallback, const description::Pointer& pointer);
/// The location of a key in the description of a unit, with the unit's first symbol as fallback. The unit must be
/// described.
diag::Location described_location(const model::PlantModel& plant, const model::Unit& unit,
                                  const description::Pointer& pointer);
/// An entry for a unit's device; its `only` if that removes the derived transitions.
description::Pointer entry_pointer(const model::Unit& unit);
description::Pointer transitions_pointer(const model::Unit& unit);
/// Where a transition is given, or one of its keys.
description::Pointer transition_pointer(const model::Unit& unit, const model::Transition& transition,
                                        std::string_view key = {});
/// Whether the plant has a description at all.
bool has_description(const model::PlantModel& plant);
/// Whether it has devices or requirements, and no faults, so that it can be examined.
bool is_described(const Subject& subject);
/// What the derivation noticed about a unit of the plant.
const model::UnitEvidence& evidence_of(const Subject& subject, const model::Unit& unit);
/// The symbol at an index of a unit's operations or events.
const model::Symbol& operation_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location);
const model::Symbol& event_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t location);
/// The first symbol of a unit in list order.
const model::Symbol& first_symbol_of(const model::PlantModel& plant, const model::Unit& unit);
/// The subjects of a finding, as the user can name them in the settings: a symbol and its device, or a device.
diag::Subjects about(const model::Symbol& symbol);
/// Of two symbols with one address: the other's name is second.
diag::Subjects about(const model::Symbol& symbol, const model::Symbol& other);
diag::Subjects about(const model::Unit& unit);
diag::Subjects about(const read::ListRow& row);

/// Another name for a symbol.
diag::Rename rename_of(const model::Symbol& symbol, std::string to, bool safe);

/// For findings that repeat in all devices of a type: `CLAMP#`, or the shape of the path if the device has no number.
std::string type_shape(const model::Unit& unit);

// Subjects that connect a finding with its cause and its consequences.
diag::Subject device(std::string_view path);
diag::Subject model_of(std::string_view path);
diag::Subject sequence_of(std::string_view path);
diag::Subject symbol_named(std::string_view name);
diag::Subject address_of(std::string_view symbol);
diag::Subject missing(std::string name);
/// The symbol that a device has not, for a task and a direction.
diag::Subject missing(const model::PlantModel& plant, std::string_view path, tables::Direction direction,
                      std::string_view task);
/// The operations, or the events, of a device.
diag::Subject side_of(std::string_view path, tables::Direction direction);
/// Adds what the lack of a symbol explains: the symbol itself, a device without operations or events, and its model.
void explain_missing(diag::Subjects& subjects, std::string name, std::string_view path, tables::Direction direction);
/// For each state of the unit that has only one side, the symbol of the other side. Callers add up to `more` subjects.
std::vector<diag::Subject> missing_sides(const model::PlantModel& plant, const model::Unit& unit, std::size_t more);
/// A device; the finding is about what was derived for it, and follows from whatever the device lacks.
diag::Subjects about_model(const model::PlantModel& plant, const model::Unit& unit);
/// Adds to the subjects of a device without events, or without operations, the symbols that it lacks. The finding
/// explains what else follows from them.
diag::Subjects about_sides(const model::PlantModel& plant, const model::Unit& unit, diag::Subjects subjects);
/// The symbol of a row; null if the row is left out. O(log symbols).
const model::Symbol* symbol_of(const model::PlantModel& plant, const read::ListRow& row);
/// "operation" or "event".
std::string_view direction_text(tables::Direction direction);

}  // namespace symplant::check
