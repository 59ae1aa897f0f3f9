// The contract of the templates.
#include "emit/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace symplant::emit {
namespace {

constexpr auto kKeys = std::to_array<Key>({
    {"version", "", false, "the tool's version"},
    {"version_required", "", false, "the version of the package that the code needs, for find_package"},
    {"tables_version", "", false, "the runtime's tables version that the code is made for"},
    {"list", "", false, "the symbol lists' file names, for a comment"},
    {"plant", "", false, "the plant's name, for a comment"},
    {"namespace", "", false, "the plant's name as an identifier"},
    {"open", "", false, "an opening brace, for where two in a row would be a tag"},
    {"close", "", false, "a closing brace"},
    {"unit_count", "", false, "devices of the plant"},
    {"symbol_count", "", false, "I/O symbols of the plant"},
    {"random_time_count", "", false, "times of the plant that are drawn"},
    {"type_count", "", false, "device types of the plant"},

    {"types", "", true, "the device types"},
    {"title", "types", false, "what the type is, for a comment"},
    {"class", "types", false, "its class"},
    {"device_count", "types", false, "its devices"},
    {"devices", "types behaviours", true, "lines about its devices"},
    {"device", "devices", false, "one such line, for a comment"},
    {"operations", "types", true, "I"},
    {"events", "types", true, "O"},
    {"states", "types", true, "S"},
    {"enumerator", "operations events states guards guard inputs values", false, "its enumerator in the class"},
    {"number", "operations events states guards guard transitions leaving", false, "its number in the type, from 0"},
    {"task", "operations events values", false, "its task, for a comment"},
    {"name", "states", false, "its name, for a comment"},
    {"symbol", "operations events values", false, "the symbol of the type's first device, for a comment"},
    {"address", "operations events values", false, "its address, for a comment"},
    {"cite", "operations events values", false, "its list and line, for a comment"},
    {"meaning", "states inputs", false, "where the state comes from, or the input's condition, for a comment"},
    {"operation_count", "types", false, ""},
    {"event_count", "types", false, ""},
    {"state_count", "types", false, ""},
    {"operation_list", "types", false, "I as initializers"},
    {"event_list", "types", false, "O as initializers"},
    {"state_list", "types", false, "S as initializers"},
    {"target_list", "types", false, "for each operation the state of its name, as initializers"},
    {"rest", "types", false, "the state to which a spring returns, as an initializer"},
    {"actuation", "types", false, "latched, bistable, held or spring"},

    {"times", "types", true, "the named times of the class"},
    {"dt", "times transitions leaving", false, "the name of a time"},
    {"value", "times members", false, "its initializer, or a member's value"},
    {"note", "times", false, "what the initializer does not say, with `//`; may be empty"},
    {"after_ms", "times transitions leaving returns", false,
     "how long the cause must hold, in ms: of the first device, if each has its own; the mean, if it is random"},
    {"takes_ms", "times transitions leaving returns", false, "the travel time, as for after_ms"},
    {"guarded", "types", true, "one item if the type has guards, else empty"},
    {"guards", "types", true, "the conditions that guard a start"},
    {"condition", "guards", false, "such a condition, for a comment"},
    {"of", "guards", false, "whose condition that is, if each device has its own; for a comment"},

    {"transitions", "types", true, "d_ext and d_int, in the order of the model's table"},
    {"leaving", "states", true, "those of them that leave the state, with the same keys"},
    {"returns", "types", true, "one item if a spring returns the device to rest, else empty"},
    {"initial", "types", false, "the number of the first device's initial state"},
    {"to_number", "transitions leaving returns", false, "the number of the state to which it leads"},
    {"from", "transitions leaving", false, "the enumerator of the state that it leaves"},
    {"from_number", "transitions leaving", false, "the number of that state"},
    {"to", "transitions leaving returns operation_rules", false, "the enumerator of the state to which it leads"},
    {"about", "transitions leaving row_tables text_tables", false, "what it is or holds, for a comment"},
    {"by_operation", "transitions leaving", true, "one item if an operation commands it, else empty"},
    {"operation", "by_operation moves operation_rules", false, "the enumerator of the operation"},
    {"by_itself", "transitions leaving", true, "one item if it is automatic, else empty"},
    {"by_spring", "transitions leaving", true, "one item if it is the return of a spring, else empty"},
    {"guard", "transitions leaving", true, "one item if it has a guard, else empty"},
    {"once", "transitions leaving", true, "one item if its operation works once, else empty"},
    {"priority", "transitions leaving", false, "its priority; empty if it has none"},
    {"enter_on", "states", true, "l_enter: the events that are switched on"},
    {"enter_off", "states", true, "l_enter: the events that are switched off"},
    {"leave_on", "states", true, "l_leave: the events that are switched on"},
    {"leave_off", "states", true, "l_leave: the events that are switched off"},
    {"event", "enter_on enter_off leave_on leave_off", false, "the enumerator of such an event"},

    {"moves_size", "types", false, "what tables::Moves needs if more than four moves lead out of a state at once"},
    {"commanded", "types", true, "one item if d_ext leads anywhere, else empty"},
    {"by_rules", "types", true, "one item if there are operation_rules, else empty"},
    {"operation_rules", "types", true,
     "operations that lead from every other state to one, all with the same time and guard"},
    {"by_states", "types", true, "one item if there are commanded_states, else empty"},
    {"commanded_states", "types", true, "states that other operations leave"},
    {"moves", "commanded_states", true, "those operations"},
    {"automatic", "types", true, "one item if d_int leads anywhere, else empty"},
    {"automatic_states", "types", true, "states that are left automatically"},
    {"spring", "types", true, "one item if there are spring_states, else empty"},
    {"spring_states", "types", true, "states whose return to rest has a separate time"},
    {"state", "commanded_states automatic_states spring_states entered left", false, "the enumerator of the state"},
    {"go", "operation_rules moves automatic_states spring_states", false, "where it leads, as a C++ expression"},
    {"enters", "types", true, "one item if l_enter switches anything, else empty"},
    {"entered", "types", true, "states that switch events when they are entered"},
    {"leaves", "types", true, "one item if l_leave switches anything, else empty"},
    {"left", "types", true, "states that switch events when they are left"},
    {"events", "entered left", false, "what they switch, as a C++ expression"},

    {"view_includes", "", true, "one item if a device has a custom behavior, else empty"},
    {"include", "view_includes", false, "the header that behaviors need"},
    {"behaviour_views", "types", true, "one item if the type's devices have a custom behavior, else empty"},
    {"behaviour", "behaviour_views behaviours", false, "the user's class"},
    {"inputs", "behaviour_views", true, "the conditions that the behavior sees"},
    {"values", "behaviour_views", true, "the device's numeric symbols"},
    {"value_count", "behaviour_views", false, ""},
    {"value_kinds", "behaviour_views", false, "values of plant::ValueKind, as initializers"},
    {"own_code", "", true, "one item if the plant has custom behaviors, else empty"},
    {"behaviours", "", true, "the custom behaviors, by index; behavior.hpp is filled for each of them"},
    {"base", "behaviours", false, "the generated class from which it is derived"},
    {"behaviour_file", "behaviours", false, "the user's file"},

    {"symbol_constant_rows", "", false, "enumerators of Symbol"},
    {"plant_base", "", false,
     "the class from which the plant class is derived: NamedPlant, PartsPlant if it has parts, MalfunctionsPlant if it "
     "has malfunctions"},
    {"plant_arguments", "", false,
     "its template arguments: enumerations of plant_gen.hpp, or the class without malfunctions"},
    {"malfunctions", "", true, "one item if the plant has written malfunctions, else empty"},
    {"malfunction_constant_rows", "malfunctions", false, "enumerators of Malfunction"},
    {"parts", "", true, "one item if the plant has a material flow, else empty"},
    {"location_constant_rows", "parts", false, "enumerators of Location"},
    {"part_kind_constant_rows", "parts", false, "enumerators of PartKind"},
    {"formulas", "", true, "one item if the plant has formulas, else empty"},
    {"formula_function_rows", "formulas", false, "a function for each formula"},
    {"formula_entry_rows", "formulas", false, "the entries of these functions in the table of compiled formulas"},
    {"group_rows", "", false, "a class for each line and process"},
    {"accessor_rows", "", false, "functions of the plant class that give its devices and values"},
    {"link_count", "", false, "links of the plant's description"},
    {"link_rows", "", false, "those links: controller, URL"},
    {"programs", "", true, "one item if the plant's description has PLC programs, else empty"},
    {"program_count", "programs", false, "those programs"},
    {"ignored_variables", "programs", false, "arrays of the patterns of variables that need no symbol"},
    {"program_rows", "programs", false,
     "those programs: controller, file, period and delay in ns, what operations do on loss"},
    {"ignored_count", "", false, "findings of a run that the plant's description ignores"},
    {"ignored_rows", "", false, "those findings: name, pattern, last day"},
    {"view", "", true, "one item if the panel's layout does not follow from the names of devices, else empty"},
    {"device_view_count", "view", false, "the number of devices"},
    {"device_view_rows", "view", false, "where the panel shows each device: station, x, y"},
    {"station_rows", "view", false, "the names of lines and processes, as one text"},
    {"symbol_views", "", true, "one item if a symbol has a comment or is operated by a person, else empty"},
    {"symbol_view_count", "symbol_views", false, "the number of symbols"},
    {"symbol_view_rows", "symbol_views", false, "the comment of each symbol, and whether a person operates it"},
    {"alarm_views", "", true, "one item if the plant has alarms, else empty"},
    {"alarm_view_count", "alarm_views", false, ""},
    {"alarm_view_rows", "alarm_views", false, "the operation or the value of each alarm"},
    {"shapes", "", true, "one item if a device has a shape in the panel's plan, else empty"},
    {"shape_rows", "shapes", false, "the shape of each device"},
    {"plan", "", true, "one item if the plant's description has `plan`, else empty"},
    {"plan_rows", "plan", false, "it, as JSON in string literals"},
    {"view3d", "", true, "one item if the plant's description has `view3d`, else empty"},
    {"view3d_rows", "view3d", false, "it, as JSON in string literals"},
    {"type_rows", "", false, "the rows of the types"},
    {"controller_count", "", false, "controllers of the plant"},
    {"link_settings_rows", "", false, "how each of them is linked: members of link::LinkSettings"},
    {"place_arrays", "", false, "arrays that these settings point to"},
    {"kind_rows", "", false, "a constant for each kind of symbol"},
    {"row_tables", "", true, "the plant's tables that have rows"},
    {"text_tables", "", true, "the plant's tables of names that are not empty"},
    {"array", "row_tables text_tables", false, "the table's array"},
    {"row", "row_tables", false, "the type of its rows"},
    {"rows", "row_tables text_tables", false, "its rows; of names: string literals, each ended by a NUL"},
    {"members", "", true, "members of tables::PlantTables that are not empty"},
    {"member", "members", false, "one such member"},
});

}  // namespace

std::span<const Key> keys() { return kKeys; }

std::string fault_of_key(std::string_view key, const std::vector<std::string>& open_lists, bool as_list) {
  const auto as_used = [&](const Key& known) {
    return known.list ? fmt::format("`{0}` is a list: write `{{{{#{0}}}}} ... {{{{/{0}}}}}`", key)
                      : fmt::format("`{0}` is a text, not a list: write `{{{{{0}}}}}`", key);
  };
  const auto is_open = [&](const Key& known) {
    const std::string lists = " " + std::string(known.in) + " ";
    return known.in.empty() || std::any_of(open_lists.begin(), open_lists.end(), [&](const std::string& open) {
             return lists.find(" " + open + " ") != std::string::npos;
           });
  };
  const Key* elsewhere = nullptr;
  const Key* misused = nullptr;
  for (const Key& known : kKeys) {  // a key may have several rows
    if (known.key != key) continue;
    if (!is_open(known)) {
      elsewhere = &known;
    } else if (known.list != as_list) {
      misused = &known;
    } else {
      return {};
    }
  }
  if (misused != nullptr) return as_used(*misused);
  if (elsewhere == nullptr) return fmt::format("`{}` is not a key: see templates/README.md for the keys", key);
  const std::string_view list = elsewhere->in.substr(0, elsewhere->in.find(' '));
  return fmt::format("`{}` is known only within a list: write it between `{{{{#{}}}}}` and `{{{{/{}}}}}`", key, list,
                     list);
}

}  // namespace symplant::emit
