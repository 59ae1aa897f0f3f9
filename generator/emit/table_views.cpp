// The plant's tables for tables_gen.cpp.
#include "emit/table_views.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

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
  views.rows("follows", "kFollows", "tables::FollowRow", "A symbol that follows a condition: symbol, condition.",
             follow_rows(tables, plant));
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
