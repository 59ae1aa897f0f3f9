// The contract of the templates.
#include "emit/keys.hpp"

#include <algorithm>
#include <array>

namespace symplant::emit {
namespace {

constexpr std::string_view kTypesFile = "types_gen.hpp";
constexpr std::string_view kDevicesFile = "devices_gen.hpp";
constexpr std::string_view kTablesFile = "tables_gen.cpp";

constexpr auto kKeys = std::to_array<Key>({
    {"version", "*", false, "the tool's version"},
    {"version_required", "*", false, "the version of the package that the code needs, for find_package"},
    {"tables_version", "*", false, "the runtime's tables version that the code is made for"},
    {"list", "*", false, "the symbol list's file name, for a comment"},
    {"plant", "*", false, "the plant's name, for a comment"},
    {"namespace", "*", false, "the plant's name as an identifier"},
    {"open", "*", false, "an opening brace, where two in a row would be a tag"},
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
    {"operation_list", kTypesFile, false, "of a type: I as initialisers"},
    {"event_list", kTypesFile, false, "of a type: O as initialisers"},
    {"state_list", kTypesFile, false, "of a type: S as initialisers"},
    {"rest", kTypesFile, false, "of a type: the rest state's number, or kNoState"},
    {"actuation", kTypesFile, false, "of a type: an enumerator of core::Actuation"},
    {"transition_rows", kTypesFile, false, "of a type: rows of core::Transition"},
    {"enter_list", kTypesFile, false, "of a type: l_enter, an event mask a state"},
    {"leave_list", kTypesFile, false, "of a type: l_leave, an event mask a state"},
    {"target_list", kTypesFile, false, "of a type: an operation's own state"},
    {"device_rows", kDevicesFile, false, "enumerators of Device"},
    {"symbol_constant_rows", kDevicesFile, false, "enumerators of Symbol"},
    {"type_count", kTablesFile, false, "types of the plant"},
    {"time_count", kTablesFile, false, "rows of times"},
    {"initial_count", kTablesFile, false, "starting values"},
    {"shared_count", kTablesFile, false, "symbols on the address of another"},
    {"type_rows", kTablesFile, false, "the classes' rows"},
    {"unit_rows", kTablesFile, false, "rows of core::UnitRow"},
    {"time_rows", kTablesFile, false, "rows of core::TransitionTimes"},
    {"kind_rows", kTablesFile, false, "a constant for each kind of symbol"},
    {"symbol_rows", kTablesFile, false, "rows of core::SymbolRow"},
    {"initial_rows", kTablesFile, false, "rows of core::InitialValue"},
    {"shared_rows", kTablesFile, false, "rows of core::SharedAddress"},
    {"unit_names", kTablesFile, false, "string literals, each ended by a NUL"},
    {"state_names", kTablesFile, false, "string literals, each ended by a NUL"},
    {"symbol_names", kTablesFile, false, "string literals, each ended by a NUL"},
    {"plant_literal", kTablesFile, false, "the plant's name as a string literal"},
    {"list_literal", kTablesFile, false, "the list's file name as a string literal"},
    {"operation_bits", kTablesFile, false, "size of the plane of bit operations"},
    {"event_bits", kTablesFile, false, "size of the plane of bit events"},
    {"operation_slots", kTablesFile, false, "numeric operations"},
    {"event_slots", kTablesFile, false, "numeric events"},
});

}  // namespace

std::span<const Key> keys() { return kKeys; }

bool is_key(std::string_view template_name, std::string_view key) {
  return std::any_of(kKeys.begin(), kKeys.end(), [&](const Key& known) {
    return known.key == key && (known.where == "*" || known.where == template_name);
  });
}

}  // namespace symplant::emit
