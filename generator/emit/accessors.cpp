// Functions of the plant class that give its devices by line, process and name.
#include "emit/accessors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index_table.hpp"
#include "elements/value/functions.hpp"
#include "text/ascii.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

/// Members of the base classes of a plant in upper case; an accessor of the plant would hide them.
constexpr auto kPlantMembers = std::to_array<std::string_view>({
    "ACTIVE_MALFUNCTIONS",
    "ADVANCE_BEFORE",
    "ADVANCE_TO",
    "AFTER_LEFT",
    "CHANGED_EVENT_VALUES",
    "CHANGED_EVENTS",
    "DISARMED",
    "EVENT",
    "EVENT_VALUE",
    "EVENTS",
    "FORCE",
    "FORGET_CHANGED_EVENTS",
    "GONE",
    "INDEX",
    "IS_ACTIVE",
    "IS_CUT",
    "IS_FORCED",
    "IS_FROZEN_TRACK",
    "IS_ON",
    "IS_PENDING",
    "IS_STUCK",
    "LOST_FINDINGS",
    "MADE",
    "MALFUNCTION",
    "MALFUNCTION_NUMBERS",
    "MALFUNCTION_OF_SYMBOL",
    "MODEL_HASH",
    "MEMORY_SIZE",
    "MOTION",
    "NEXT_DUE",
    "NOW",
    "OPERATION",
    "OPERATION_VALUE",
    "OPERATIONS",
    "OUTPUT",
    "OUTPUT_RANGE",
    "PART",
    "PARTS",
    "PARTS_GONE",
    "PARTS_MADE",
    "PARTS_PRESENT",
    "PLANT",
    "PULSED_EVENTS",
    "PUT",
    "RELEASE",
    "RESET",
    "RESTORE",
    "ROW",
    "SAVE",
    "SET",
    "SET_INPUT",
    "SET_OPERATION",
    "SET_OPERATION_VALUE",
    "SET_OPERATIONS",
    "SET_QUALITY",
    "SET_STATE",
    "SET_STUCK",
    "SET_VALUE",
    "SHOW",
    "SHOW_ON_REQUEST",
    "SHOW_OUTPUTS",
    "SOURCE",
    "START",
    "START_MALFUNCTION",
    "STATE_HASH",
    "STOP",
    "STOP_MALFUNCTION",
    "TABLES",
    "TAKE",
    "TAKE_FINDING",
    "TRANSFER",
    "UNIT",
    "VALUE",
    "WATCH_OUTPUTS",
    "WEIGHT",
    "WRITTEN_OPERATION_VALUE",
});

/// A device name without the number at its end, and that number; no number if it has none or a very long one.
struct Numbered {
  std::string stem;
  std::uint64_t number = 0;
  bool is = false;
};

Numbered numbered(const std::string& device) {
  const std::size_t last = device.find_last_not_of("0123456789");
  const std::size_t begin = last == std::string::npos ? 0 : last + 1;
  Numbered result{device.substr(0, begin)};
  const char* const end = device.data() + device.size();
  const auto [stop, error] = std::from_chars(device.data() + begin, end, result.number);
  result.is = begin != 0 && begin < device.size() && stop == end && error == std::errc{};
  return result;
}

/// A custom naming rule may leave a level empty.
std::string path_of(const std::string& line, const std::string& process) {
  std::string path = line;
  return path.append(line.empty() || process.empty() ? "" : "_").append(process);
}

/// A plant of more devices has no accessors for single devices itself: g++ takes time for the square of the members.
constexpr std::size_t kMostDevicesOfPlant = 1000;
constexpr std::size_t kMostValuesOfPlant = 1000;  ///< for the same reason

/// By name in upper case, so that the order of rows does not count.
using Devices = std::map<std::string, std::uint32_t>;
using Processes = std::map<std::string, Devices>;
using Lines = std::map<std::string, Processes>;

/// Names by number, in the order in which they are added, and whether any other is equal. The names must outlive it.
class NamesInPlant {
 public:
  explicit NamesInPlant(std::size_t expected) : table_(expected) {
    names_.reserve(expected);
    single_.reserve(expected);
  }

  void add(std::string_view name) {
    const auto number = static_cast<std::uint32_t>(names_.size());
    names_.push_back(name);
    const std::uint32_t first = table_.find_or_add(text::hash_ignoring_case(name), number,
                                                   [&](std::uint32_t other) { return names_[other] == name; });
    single_.push_back(first == number);
    if (first != number) single_[first] = false;
  }

  bool is_single(std::size_t number) const { return single_[number]; }

 private:
  base::IndexTable table_;
  std::vector<std::string_view> names_;
  std::vector<bool> single_;
};

class Writer {
 public:
  Writer(const lower::EngineTables& tables, const model::PlantModel& plant, const std::vector<std::string>& classes,
         const std::string& name_space)
      : tables_(tables), plant_(plant), classes_(classes), name_space_(name_space) {
    for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
      const model::Unit& unit = plant.units[u];
      const std::uint32_t first = unit.first_symbol();
      const model::SymbolReading& name = plant.symbols[first].reading;
      Devices& devices = lines_[text::to_upper(name.line())][text::to_upper(name.process())];
      std::string device = text::to_upper(name.device());
      if (unit.facet != nullptr && !unit.facet->name.empty()) device += "_" + text::to_upper(unit.facet->name);
      while (!devices.emplace(device, u).second) device += "_";
    }
    text::IdentifierScope scope;
    for (const auto& [line, processes] : lines_) {
      if (!line.empty()) line_names_[line] = scope.unique(line);
      for (const auto& [process, devices] : processes) {
        process_names_[{line, process}] = scope.unique(path_of(line, process));
      }
    }
  }

  void write_groups(RowWriter& rows) const {
    for (const auto& [line, processes] : lines_) {
      for (const auto& [process, devices] : processes) {
        add_process(rows, path_of(line, process), process_names_.at({line, process}), devices);
      }
      if (!line.empty()) add_line(rows, line, processes);
    }
  }

  /// Lines always; processes and devices under a name that nothing else in the plant has.
  void write_plant(RowWriter& rows) const {
    NamesInPlant names(plant_.units.size());
    for (const auto& [line, processes] : lines_) {
      names.add(line);
      for (const auto& [process, devices] : processes) {
        names.add(process);
        for (const auto& [device, unit] : devices) names.add(device);
      }
    }
    text::IdentifierScope scope{kPlantMembers};
    const auto add = [&](const std::string& name, const std::string& type) {
      rows.text("  groups::").text(type).text(" ").text(scope.unique(text::to_lower(name)));
      rows.text("() noexcept { return groups::").text(type).text("(*this); }\n");
    };
    for (const auto& [line, type] : line_names_) add(line, type);
    for (const std::string_view member : kPlantMembers) names.add(member);
    const bool few = plant_.units.size() <= kMostDevicesOfPlant;
    std::size_t number = 0;
    for (const auto& [line, processes] : lines_) {
      ++number;
      for (const auto& [process, devices] : processes) {
        if (names.is_single(number++)) add(process, process_names_.at({line, process}));
        for (const auto& [device, unit] : devices) {
          if (names.is_single(number++) && few) add_device(rows, scope.unique(text::to_lower(device)), unit, "*this");
        }
      }
    }
    if (tables_.values.outputs > kMostValuesOfPlant)
      rows.text("  // Too many values for a function each: output() gives them.\n");
    if (tables_.values.outputs <= kMostValuesOfPlant) add_values(rows, scope);
  }

 private:
  const std::string& class_of(std::uint32_t unit) const { return classes_[tables_.units[unit].type]; }

  static void begin_group(RowWriter& rows, const std::string& path, const std::string& name) {
    rows.text("/// ").comment(path).text("\nclass ").text(name).text(" {\n public:\n  explicit ").text(name);
    rows.text("(symplant::plant::Plant& plant) noexcept : plant_(plant) {}\n");
  }
  static void end_group(RowWriter& rows) { rows.text("\n private:\n  symplant::plant::Plant& plant_;\n};\n\n"); }

  void add_device(RowWriter& rows, const std::string& name, std::uint32_t unit, std::string_view plant) const {
    rows.text("  symplant::plant::Device<::").text(name_space_).text("::").text(class_of(unit)).text("> ").text(name);
    rows.text("() ").text(plant == "plant_" ? "const " : "").text("noexcept { return {").text(plant).text(", ");
    rows.number(unit).text("}; }  // ").comment(plant_.units[unit].path).text("\n");
  }

  /// What each value shows, and a function that sets it, if that is possible.
  void add_values(RowWriter& rows, text::IdentifierScope& scope) const {
    for (std::uint32_t o = 0; o < tables_.values.outputs; ++o) {
      const std::string name = model::output_name(plant_, o);
      rows.text("  double ").text(scope.unique(function_name(name))).text("() const noexcept { return output(");
      rows.number(o).text("); }  // ").comment(name).text("\n");
    }
    for (std::uint32_t v = 0; v < plant_.values.size(); ++v) {
      if (!tables::keeps_its_output(plant_.values[v].row.kind)) continue;
      rows.text("  bool ").text(scope.unique("set_" + function_name(plant_.values[v].name)));
      rows.text("(double number) noexcept { return set_value(").number(v).text(", number); }\n");
    }
  }

  void add_process(RowWriter& rows, const std::string& path, const std::string& type, const Devices& devices) const {
    text::IdentifierScope scope;
    begin_group(rows, path, type);
    std::map<std::string, std::vector<std::pair<std::uint64_t, std::uint32_t>>> series;
    for (const auto& [device, unit] : devices) {
      add_device(rows, scope.unique(text::to_lower(device)), unit, "plant_");
      const Numbered parts = numbered(device);
      if (parts.is) series[parts.stem].emplace_back(parts.number, unit);
    }
    for (auto& [stem, numbered_units] : series) {
      auto& units = numbered_units;  // lambdas cannot capture a structured binding
      std::sort(units.begin(), units.end());
      const bool one_type = std::all_of(units.begin(), units.end(), [&](const auto& unit) {
        return tables_.units[unit.second].type == tables_.units[units.front().second].type;
      });
      const bool distinct = std::adjacent_find(units.begin(), units.end(), [](const auto& a, const auto& b) {
                              return a.first == b.first;
                            }) == units.end();
      if (units.size() > 1 && one_type && distinct && devices.find(stem) == devices.end()) {
        add_series(rows, scope.unique(text::to_lower(stem)), units);
      }
    }
    end_group(rows);
  }

  void add_series(RowWriter& rows, const std::string& name,
                  const std::vector<std::pair<std::uint64_t, std::uint32_t>>& units) const {
    rows.text("  symplant::plant::DeviceArray<::").text(name_space_).text("::").text(class_of(units.front().second));
    rows.text("> ").text(name).text("() const noexcept {  // by number\n");
    rows.text("    static constexpr symplant::plant::NumberedUnit kUnits[] = {");
    for (std::size_t i = 0; i < units.size(); ++i) {
      rows.text(i == 0 ? "{" : ", {").number(units[i].first).text("U, ").number(units[i].second).text("}");
    }
    rows.text("};\n    return {plant_, kUnits};\n  }\n");
  }

  void add_line(RowWriter& rows, const std::string& line, const Processes& processes) const {
    text::IdentifierScope scope;
    begin_group(rows, line, line_names_.at(line));
    for (const auto& [process, devices] : processes) {
      const std::string& type = process_names_.at({line, process});
      rows.text("  ").text(type).text(" ").text(scope.unique(text::to_lower(process)));
      rows.text("() const noexcept { return ").text(type).text("(plant_); }\n");
    }
    end_group(rows);
  }

  const lower::EngineTables& tables_;
  const model::PlantModel& plant_;
  std::vector<std::string> classes_;
  std::string name_space_;
  Lines lines_;
  std::map<std::string, std::string> line_names_;                             ///< of classes, by line
  std::map<std::pair<std::string, std::string>, std::string> process_names_;  ///< of classes, by line and process
};

}  // namespace

Accessors accessors(const lower::EngineTables& tables, const model::PlantModel& plant,
                    const std::vector<std::string>& classes, const std::string& name_space) {
  const auto writer = std::make_shared<const Writer>(tables, plant, classes, name_space);
  return {[writer](RowWriter& rows) { writer->write_groups(rows); },
          [writer](RowWriter& rows) { writer->write_plant(rows); }};
}

}  // namespace symplant::emit
