// The contract of the templates.
#include "emit/keys.hpp"

#include <algorithm>
#include <array>

namespace symplant::emit {
namespace {

constexpr std::string_view kTypesFile = "types_gen.hpp";
constexpr std::string_view kDevicesFile = "devices_gen.hpp";
constexpr std::string_view kMainFile = "main_gen.cpp";
constexpr std::string_view kTablesFile = "tables_gen.cpp";
constexpr std::string_view kBehavioursFile = "behaviours_gen.cpp";

constexpr auto kKeys = std::to_array<Key>({
    {"version", "*", false, "the tool's version"},
    {"version_required", "*", false, "the version of the package that the code needs, for find_package"},
    {"tables_version", "*", false, "the runtime's tables version that the code is made for"},
    {"list", "*", false, "the symbol lists' file names, for a comment"},
    {"plant", "*", false, "the plant's name, for a comment"},
    {"namespace", "*", false, "the plant's name as an identifier"},
    {"open", "*", false, "an opening brace, for where two in a row would be a tag"},
    {"close", "*", false, "a closing brace"},
    {"unit_count", "*", false, "devices of the plant"},
    {"symbol_count", "*", false, "I/O symbols of the plant"},
    {"types", kTypesFile, true, "the device types"},
    {"title", kTypesFile, false, "of a type: what it is, for a comment"},
    {"class", kTypesFile, false, "of a type: its class"},
    {"devices", kTypesFile, true, "of a type: lines about its devices"},
    {"device", kTypesFile, false, "one such line, for a comment"},
    {"operations", kTypesFile, true, "of a type: I"},
    {"events", kTypesFile, true, "of a type: O"},
    {"states", kTypesFile, true, "of a type: S"},
    {"enumerator", kTypesFile, false, "of an operation, event or state: its enumerator"},
    {"symbol", kTypesFile, false, "of an operation or event: the symbol of the type's first device, for a comment"},
    {"address", kTypesFile, false, "of an operation or event: its address, for a comment"},
    {"cite", kTypesFile, false, "of an operation or event: list and line, for a comment"},
    {"meaning", kTypesFile, false, "of a state: where it comes from, for a comment"},
    {"operation_count", kTypesFile, false, "of a type"},
    {"event_count", kTypesFile, false, "of a type"},
    {"state_count", kTypesFile, false, "of a type"},
    {"transition_count", kTypesFile, false, "of a type"},
    {"operation_list", kTypesFile, false, "of a type: I as initializers"},
    {"event_list", kTypesFile, false, "of a type: O as initializers"},
    {"state_list", kTypesFile, false, "of a type: S as initializers"},
    {"rest", kTypesFile, false, "of a type: the rest state's number, or kNoState"},
    {"actuation", kTypesFile, false, "of a type: an enumerator of tables::Actuation"},
    {"transition_rows", kTypesFile, false, "of a type: rows of tables::Transition"},
    {"enter_rows", kTypesFile, false, "of a type: l_enter, rows of tables::EventMasks, a state each"},
    {"leave_rows", kTypesFile, false, "of a type: l_leave, rows of tables::EventMasks, a state each"},
    {"target_list", kTypesFile, false, "of a type: the target state of each operation"},
    {"view_includes", kTypesFile, true, "one item if a device has a behavior, else empty"},
    {"include", kTypesFile, false, "of it: the header that behaviors need"},
    {"behaviour_views", kTypesFile, true, "of a type: one item if its devices have a behavior, else empty"},
    {"behaviour", kTypesFile, false, "of it: the user's class"},
    {"inputs", kTypesFile, true, "of it: the conditions that the behavior sees; `enumerator` and `meaning`"},
    {"values", kTypesFile, true, "of it: numeric symbols; `enumerator`, `symbol`, `address`, `cite`"},
    {"value_count", kTypesFile, false, "of it"},
    {"value_kinds", kTypesFile, false, "of it: values of plant::ValueKind, as initializers"},
    {"own_code", kBehavioursFile, true, "one item if the plant has behaviors, else empty"},
    {"behaviours", kBehavioursFile, true, "of it: the behaviors, by index"},
    {"behaviour", kBehavioursFile, false, "of a behavior: the user's class"},
    {"base", kBehavioursFile, false, "of a behavior: the generated class that it is derived from"},
    {"behaviour_file", kBehavioursFile, false, "of a behavior: the user's file"},
    {"behaviour", kOwnFile, false, "the user's class"},
    {"base", kOwnFile, false, "the generated class that it is derived from"},
    {"devices", kOwnFile, true, "lines about its devices"},
    {"device", kOwnFile, false, "one such line, for a comment"},
    {"device_rows", kDevicesFile, false, "enumerators of Device"},
    {"symbol_constant_rows", kDevicesFile, false, "enumerators of Symbol"},
    {"link_count", kMainFile, false, "links of the plant's description"},
    {"link_rows", kMainFile, false, "those links: controller, URL"},
    {"type_count", kTablesFile, false, "types of the plant"},
    {"type_rows", kTablesFile, false, "the classes' rows"},
    {"controller_count", kTablesFile, false, "controllers of the plant"},
    {"link_settings_rows", kTablesFile, false, "how each of them is linked: members of link::LinkSettings"},
    {"place_arrays", kTablesFile, false, "arrays that these settings point to"},
    {"kind_rows", kTablesFile, false, "a constant for each kind of symbol"},
    {"row_tables", kTablesFile, true, "the plant's tables that have rows"},
    {"text_tables", kTablesFile, true, "the plant's tables of names that are not empty"},
    {"array", kTablesFile, false, "of such a table: its array"},
    {"row", kTablesFile, false, "of a table with rows: their type"},
    {"about", kTablesFile, false, "of such a table: what it holds, for a comment"},
    {"rows", kTablesFile, false, "of such a table: rows; of names: string literals, each ended by a NUL"},
    {"members", kTablesFile, true, "members of tables::PlantTables that are not empty"},
    {"member", kTablesFile, false, "one such member"},
    {"value", kTablesFile, false, "its value"},
});

}  // namespace

std::span<const Key> keys() { return kKeys; }

bool is_key(std::string_view template_name, std::string_view key) {
  return std::any_of(kKeys.begin(), kKeys.end(), [&](const Key& known) {
    return known.key == key && (known.where == "*" || known.where == template_name);
  });
}

}  // namespace symplant::emit
