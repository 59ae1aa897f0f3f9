// The plant's tables for tables_gen.cpp.
#include "emit/table_views.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "elements/follow/rows.hpp"
#include "elements/malfunction/rows.hpp"
#include "elements/material/rows.hpp"
#include "elements/requirement/rows.hpp"
#include "elements/value/rows.hpp"
#include "emit/condition_rows.hpp"
#include "emit/encode.hpp"
#include "emit/rows.hpp"

namespace symplant::emit {
namespace {

using tables::Direction;

/// Collects tables and the members that hold them, in the order of tables::PlantTables. Omits tables without rows.
class TableViews {
 public:
  explicit TableViews(View& view)
      : row_tables_(view.lists["row_tables"]),
        text_tables_(view.lists["text_tables"]),
        members_(view.lists["members"]) {}

  void rows(const char* member, const char* array, const char* row, std::string_view about, std::string rows) {
    if (rows.empty()) return;
    value(member, array);
    row_tables_.push_back(
        {{{"array", array}, {"row", row}, {"about", std::string(about)}, {"rows", std::move(rows)}}, {}});
  }

  /// A table whose rows are written on demand.
  void rows(const char* member, const char* array, const char* row, std::string_view about, bool any,
            RowSource source) {
    if (!any) return;
    value(member, array);
    row_tables_.push_back({{{"array", array}, {"row", row}, {"about", std::string(about)}}, {}, {{"rows", source}}});
  }

  void texts(const char* member, const char* array, std::string_view about, const std::string& blob, int per_line) {
    if (blob.empty()) return;
    value(member, fmt::format("{{{0}, sizeof {0} - 1}}", array));
    const RowSource source = [&blob, per_line](RowWriter& rows) { name_rows(rows, blob, per_line); };
    text_tables_.push_back({{{"array", array}, {"about", std::string(about)}}, {}, {{"rows", source}}});
  }

  void value(const char* member, std::string value) {
    members_.push_back({{{"member", member}, {"value", std::move(value)}}, {}});
  }

 private:
  std::vector<View>& row_tables_;
  std::vector<View>& text_tables_;
  std::vector<View>& members_;
};

void add_conditions(TableViews& views, const lower::EngineTables& tables, const model::PlantModel& plant) {
  views.rows("conditions", "kConditions", "tables::ConditionRow",
             "A condition: truth table, its reader, which input of the reader it is.", condition_rows(tables, plant));
  views.rows("conditioned_units", "kConditionedUnits", "tables::ConditionedUnit",
             "A device with conditions: device, its first condition.", conditioned_unit_rows(tables, plant));
  views.rows("unit_watches", "kUnitWatches", "tables::UnitWatch",
             "A device state that a condition watches: device, condition, state, input of the condition.",
             unit_watch_rows(tables, plant));
  const char* const bits = "bit, condition, input of the condition.";
  views.rows("operation_watches", "kOperationWatches", "tables::BitWatch",
             fmt::format("An operation that a condition watches: {}", bits),
             bit_watch_rows(tables, plant, Direction::operation));
  views.rows("event_watches", "kEventWatches", "tables::BitWatch",
             fmt::format("An event that a condition watches: {}", bits),
             bit_watch_rows(tables, plant, Direction::event));
  const char* const values = "operand, slot, condition, input of the condition, comparison, kind of number.";
  views.rows("operation_value_watches", "kOperationValueWatches", "tables::ValueWatch",
             fmt::format("A numeric operation that a condition compares: {}", values),
             value_watch_rows(tables, plant, Direction::operation));
  views.rows("event_value_watches", "kEventValueWatches", "tables::ValueWatch",
             fmt::format("A numeric event that a condition compares: {}", values),
             value_watch_rows(tables, plant, Direction::event));
  views.rows("requirements", "kRequirements", "tables::RequirementRow",
             "A requirement: kind, condition, expected condition, time limit (ns).", requirement_rows(tables, plant));
  views.rows("follows", "kFollows", "tables::FollowRow",
             "A symbol that follows a condition: symbol, condition, maybe another one that switches it off.",
             follow_rows(tables, plant));
}

void add_malfunctions(TableViews& views, const lower::EngineTables& tables, const model::PlantModel& plant) {
  if (plant.malfunctions.empty()) return;
  views.rows("malfunctions.rows", "kMalfunctions", "tables::MalfunctionRow",
             "A malfunction: effects (first, number), condition, whether it is active while it holds, chance and "
             "lasts (ns), becomes: after (ns), which one, unless (condition). Times below 0 are random.",
             malfunction_rows(tables));
  views.rows("malfunctions.effects", "kEffects", "tables::EffectRow",
             "What a malfunction does: kind, its devices, symbols or parameters (first, number), its tracks "
             "(first, number), how many times slower (thousandths), symbol, controller or signal, every and for "
             "(ns), gain, offset, drift. Times below 0 are random.",
             effect_rows(tables));
  views.rows("malfunctions.units", "kMalfunctionUnits", "tables::MalfunctionUnit",
             "A device of an effect: device, state.", malfunction_unit_rows(tables, plant));
  views.rows("malfunctions.tracks", "kMalfunctionTracks", "std::uint32_t", "A track of an effect.",
             malfunction_track_rows(tables, plant));
  views.rows("malfunctions.forces", "kMalfunctionForces", "tables::MalfunctionForce",
             "A symbol of an effect: symbol, value, whether it holds what it shows.",
             malfunction_force_rows(tables, plant));
  views.rows("malfunctions.sets", "kMalfunctionSets", "tables::MalfunctionSet",
             "A parameter of an effect: value, number.", malfunction_set_rows(tables, plant));
  views.texts("malfunctions.names", "kMalfunctionNames", "The malfunctions' names.", tables.malfunctions.names, 1);
}

void add_values(TableViews& views, const lower::EngineTables& tables, const model::PlantModel& plant) {
  if (tables.values.tables().empty()) return;
  views.rows("values.rows", "kValues", "tables::ValueRow",
             "A value: kind, start, min, max, step and trace (ns), output, formulas (first, number), factor, ti, "
             "td (s), steps, device, numbers, states, outputs, whether it has d, jumps (first, number).",
             value_rows(tables, plant));
  views.rows("values.order", "kValueOrder", "std::uint32_t", "Values that are computed from others, in this order.",
             value_order_rows(tables));
  views.rows("values.changes", "kChanges", "tables::ChangeRow", "A jump of a value: condition, formula.",
             change_rows(tables));
  views.rows("values.signals", "kSignals", "tables::SignalRow",
             "A signal: symbol, formula, every (ns), whether it is scaled, from a to b, to c to d, noise, limits.",
             signal_rows(tables, plant));
  views.rows("values.formulas", "kFormulas", "tables::FormulaRow",
             "A formula: its steps and its inputs (first, number).", formula_rows(tables));
  views.rows("values.steps", "kFormulaSteps", "tables::FormulaStep",
             "A step of a formula: what it does, with which input or points, with which number.",
             formula_step_rows(tables));
  if (!tables.values.formulas.empty()) views.value("values.compiled", "kCompiledFormulas<Formulas>");
  views.rows("values.inputs", "kFormulaInputs", "tables::FormulaInput",
             "An input of a formula: kind, kind of number, output, slot, counter or location.",
             formula_input_rows(tables));
  views.rows("values.numbers", "kNumbers", "double", "Points of curves, numbers of positions, matrices.",
             number_rows(tables));
  views.rows("values.comparisons", "kComparisons", "tables::ComparisonRow",
             "A comparison of two operands: each with kind, kind of number, what, number; tolerance, condition, "
             "input, comparison.",
             comparison_rows(tables));
  views.value("values.outputs", std::to_string(tables.values.outputs));
  views.texts("values.names", "kValueNames", "The values' names and units.", tables.values.names, 1);
  views.texts("values.formula_texts", "kFormulaTexts", "The texts of the formulas.", tables.values.formula_texts, 1);
}

void add_material(TableViews& views, const lower::EngineTables& tables, const model::PlantModel& plant) {
  const model::Material& material = plant.material;
  const lower::Material& rows = tables.material;
  if (material.empty()) return;
  views.rows("material.kinds", "kPartKinds", "tables::KindRow", "A kind of part: length (um), code.",
             part_kind_rows(material));
  views.rows("material.tracks", "kTracks", "tables::TrackRow",
             "A track: length, gap (um), its drives, stops, sensors and ends (first, count).",
             track_rows(tables, material));
  views.rows("material.drives", "kDrives", "tables::DriveRow",
             "A drive: up to where (um), its conditions forward and backward, the symbol of its speed, speed "
             "(um/s).",
             drive_rows(tables, plant));
  views.rows("material.stops", "kStops", "tables::StopRow", "A stop: position (um), condition.",
             stop_rows(tables, material));
  views.rows("material.ends", "kEnds", "tables::EndRow", "An end of a track: location, condition.",
             end_rows(tables, material));
  views.rows("material.sensors", "kPartSensors", "tables::SensorRow",
             "A sensor of parts: symbol, location, position (um), the kinds that it sees (first, count), reads.",
             part_sensor_rows(tables, plant));
  views.rows("material.places", "kPlaces", "tables::PlaceRow",
             "A place: how many it holds, its sensors (first, count).", place_rows(tables, material));
  views.rows("material.transfers", "kTransfers", "tables::TransferRow", "A transfer: from, to, condition, once.",
             transfer_rows(tables, material));
  views.rows("material.work", "kWork", "tables::WorkRow", "Work: location, condition, kind before, kind after.",
             work_rows(tables, material));
  views.rows("material.sources", "kSources", "tables::SourceRow",
             "A source: location, its kinds (first, count), first, every (ns; below 0: random), count, condition.",
             source_rows(tables, material));
  views.rows("material.sensor_kinds", "kSensorKinds", "std::uint32_t", "Kinds that sensors see.",
             kind_number_rows(rows.sensor_kinds, material));
  views.rows("material.source_kinds", "kSourceKinds", "std::uint32_t", "Kinds that sources make.",
             kind_number_rows(rows.source_kinds, material));
  views.rows("material.counters", "kPartCounters", "tables::PartCounterRow",
             "A number of parts that conditions read: location, kind.", part_counter_rows(tables, material));
  views.texts("material.kind_names", "kPartKindNames", "The kinds of parts.", rows.kind_names, 1);
  views.texts("material.location_names", "kLocationNames", "The tracks, then the places.", rows.location_names, 1);
  views.texts("material.transfer_names", "kTransferNames", "The transfers.", rows.transfer_names, 1);
  views.texts("material.work_names", "kWorkNames", "The work.", rows.work_names, 1);
  views.texts("material.source_names", "kSourceNames", "The sources.", rows.source_names, 1);
  views.rows("part_watches", "kPartWatches", "tables::ValueWatch",
             "A number of parts that a condition compares: operand, counter, condition, input of the condition, "
             "comparison, kind of number.",
             part_watch_rows(tables));
}

}  // namespace

void add_tables(View& view, const lower::EngineTables& tables, const model::PlantModel& plant) {
  TableViews views(view);
  views.value("name", string_literal(tables.name));
  views.value("types", "kTypes");
  views.rows(
      "units", "kUnits", "tables::UnitRow",
      "A device: type, initial state, 1 where the engine keeps a record of it, first bit of its operations, of its "
      "events, first of its times.",
      !tables.units.empty(), [&](RowWriter& rows) { unit_rows(rows, tables); });
  views.rows(
      "times", "kTimes", "tables::TransitionTimes",
      "Times in which devices of one type differ, a device's one after the other: after, takes (ns; below 0: random).",
      time_rows(tables));
  views.rows("random_times", "kRandomTimes", "tables::RandomTime",
             "Random times: minimum and maximum, or mean and standard deviation (ns).", random_rows(tables, plant));
  views.rows("symbols", "kSymbols", "tables::SymbolRow",
             "A symbol: bit or slot, device, number of its address, line in the list, kind.", !tables.symbols.empty(),
             [&](RowWriter& rows) { symbol_rows(rows, tables, plant); });
  views.rows("lists", "kLists", "tables::SymbolListRow", "A symbol list: its first symbol, its controller.",
             list_rows(tables, plant));
  views.rows("initial_values", "kInitialValues", "tables::InitialValue",
             "Initial values that no device sets: symbol, value.", !tables.initial_values.empty(),
             [&](RowWriter& rows) { initial_rows(rows, tables, plant); });
  views.rows("shared_addresses", "kSharedAddresses", "tables::SharedAddress",
             "A symbol on the address of another one: symbol, the symbol that it follows.", shared_rows(tables, plant));
  views.rows("disables", "kDisables", "tables::DisableRow",
             "A device that another one disables: the disabling device, the disabled device, the state of the former.",
             disable_rows(tables, plant));
  add_conditions(views, tables, plant);
  views.rows("overruns", "kOverruns", "tables::OverrunRow",
             "A device whose commands against its end are found: device, time (ns).", overrun_rows(tables, plant));
  add_material(views, tables, plant);
  add_malfunctions(views, tables, plant);
  add_values(views, tables, plant);
  views.rows("behaviour_units", "kBehaviourUnits", "tables::BehaviourUnit",
             "A device with a custom behavior: device, class, its inputs (first, count), its values (first, count).",
             behaviour_unit_rows(tables, plant));
  views.rows("behaviour_values", "kBehaviourValues", "std::uint32_t", "Numeric symbols of those devices.",
             behaviour_value_rows(tables, plant));
  views.value("operation_bits", std::to_string(tables.operation_bits));
  views.value("event_bits", std::to_string(tables.event_bits));
  views.value("operation_slots", std::to_string(tables.operation_slots));
  views.value("event_slots", std::to_string(tables.event_slots));
  views.texts("unit_names", "kUnitNames", "The devices' names.", tables.unit_names, 1);
  views.texts("state_names", "kStateNames", "The types' states.", tables.state_names, 8);
  views.texts("symbol_names", "kSymbolNames", "A symbol's name and address.", tables.symbol_names, 2);
  views.texts("requirement_names", "kRequirementNames", "The requirements' names.", tables.requirement_names, 1);
  views.texts("behaviour_names", "kBehaviourNames", "The names of the custom behavior classes.", tables.behaviour_names,
              1);
  views.texts("list_names", "kListNames", "The symbol lists' files.", tables.list_names, 1);
  views.texts("controller_names", "kControllerNames", "The controllers; the default one has no name.",
              tables.controller_names, 1);
}

}  // namespace symplant::emit
