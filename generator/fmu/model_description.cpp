// The description of an FMU.
#include "fmu/model_description.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "convert/xml_text.hpp"
#include "symplant/condition/type_info.hpp"
#include "symplant/fmi/instance.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::fmu {
namespace {

using fmi::BaseType;
using fmi::Variable;
using fmi::Variables;
using Kind = Variable::Kind;
using tables::NumberKind;

/// Writes elements, each on its own line.
class Xml {
 public:
  Xml& line(std::string_view markup) {
    text_.append(2 * depth_, ' ').append(markup).push_back('\n');
    return *this;
  }
  Xml& open(std::string_view tag) {
    line(fmt::format("<{}>", tag));
    ++depth_;
    return *this;
  }
  Xml& close(std::string_view name) {
    --depth_;
    return line(fmt::format("</{}>", name));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

/// ` name="text"`
std::string attribute(std::string_view name, std::string_view text) {
  std::string encoded;
  convert::append_xml(encoded, text);
  return fmt::format(" {}=\"{}\"", name, encoded);
}

std::string attribute(std::string_view name, double number) { return fmt::format(" {}=\"{}\"", name, number); }

class Description {
 public:
  Description(const model::PlantModel& plant, const tables::PlantTables& tables, const Variables& variables)
      : plant_(plant),
        tables_(tables),
        variables_(variables),
        instance_({tables, {}, variables}),
        units_(tables::split_names(tables.unit_names)),
        states_(tables::split_names(tables.state_names)),
        symbols_(tables::split_names(tables.symbol_names)),
        values_(tables::split_names(tables.values.names)),
        value_of_output_(tables.values.outputs),
        first_unit_(tables.types.size(), tables::kNone) {
    for (std::uint32_t v = 0; v < tables.values.rows.size(); ++v) {
      const tables::ValueRow& row = tables.values.rows[v];
      for (std::uint32_t i = 0; i < row.outputs; ++i) value_of_output_[row.output + i] = v;
    }
    for (std::uint32_t u = 0; u < tables.units.size(); ++u) {
      std::uint32_t& first = first_unit_[tables.units[u].type];
      if (first == tables::kNone) first = u;
    }
  }

  std::string text(const std::string& identifier) {
    xml_.line("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    xml_.open("fmiModelDescription fmiVersion=\"2.0\"" + attribute("modelName", tables_.name) +
              attribute("guid", fmi::guid_of(tables_, variables_)) +
              attribute("description", "A plant made from " + plant_.list_names()) +
              attribute("generationTool", fmt::format("symplant {}", tables::version())) +
              " variableNamingConvention=\"flat\"");
    xml_.line("<CoSimulation" + attribute("modelIdentifier", identifier) +
              " canHandleVariableCommunicationStepSize=\"true\" canNotUseMemoryManagementFunctions=\"true\""
              " canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"/>");
    units();
    types();
    xml_.open("LogCategories");
    xml_.line("<Category name=\"logStatusError\" description=\"Why a function failed\"/>");
    xml_.line("<Category name=\"logShortPulses\" description=\"Events of which a step held a pulse to its end\"/>");
    xml_.close("LogCategories");
    xml_.line("<DefaultExperiment startTime=\"0\" stopTime=\"10\" stepSize=\"0.01\"/>");
    xml_.open("ModelVariables");
    for (std::uint32_t v = 0; v < variables_.all().size(); ++v) variable(v);
    xml_.close("ModelVariables");
    structure();
    xml_.close("fmiModelDescription");
    return xml_.take();
  }

 private:
  void units() {
    std::set<std::string_view> names;
    for (std::size_t v = 0; 2 * v + 1 < values_.size(); ++v) names.insert(values_[2 * v + 1]);
    names.erase("");
    if (names.empty()) return;
    xml_.open("UnitDefinitions");
    for (const std::string_view name : names) xml_.line("<Unit" + attribute("name", name) + "/>");
    xml_.close("UnitDefinitions");
  }

  std::string type_name(std::uint32_t type) const { return fmt::format("states of {}", units_[first_unit_[type]]); }

  /// The states of each type of device.
  void types() {
    if (tables_.units.empty()) return;
    xml_.open("TypeDefinitions");
    std::size_t first = 0;
    for (std::uint32_t t = 0; t < tables_.types.size(); ++t) {
      const std::size_t end = first + tables_.types[t].states;
      if (first_unit_[t] != tables::kNone) {
        xml_.open("SimpleType" + attribute("name", type_name(t)));
        xml_.open("Enumeration");
        for (std::size_t s = first; s < end; ++s) {
          xml_.line(fmt::format("<Item{} value=\"{}\"/>", attribute("name", states_[s]), s - first + 1));
        }
        xml_.close("Enumeration");
        xml_.close("SimpleType");
      }
      first = end;
    }
    xml_.close("TypeDefinitions");
  }

  void variable(std::uint32_t index) {
    const Variable& v = variables_.all()[index];
    xml_.open(fmt::format("ScalarVariable{} valueReference=\"{}\"{}{}", attribute("name", v.name), v.reference,
                          attribute("description", description(v)), role(v.kind)));
    std::string element;
    switch (v.type) {
      case BaseType::boolean:
        element = "Boolean";
        if (is_settable(v.kind)) element += instance_.integer(index) != 0 ? " start=\"true\"" : " start=\"false\"";
        break;
      case BaseType::integer:
        element = "Integer" + range(v);
        if (is_settable(v.kind)) element += fmt::format(" start=\"{}\"", instance_.integer(index));
        break;
      case BaseType::enumeration:
        element = "Enumeration" + attribute("declaredType", type_name(tables_.units[v.of].type));
        break;
      case BaseType::real:
        element = "Real" + unit(v) + range(v);
        if (is_settable(v.kind)) element += attribute("start", instance_.real(index));
        break;
    }
    xml_.line("<" + element + "/>");
    xml_.close("ScalarVariable");
  }

  static std::string_view role(Kind kind) {
    switch (kind) {
      case Kind::seed:
        return " causality=\"parameter\" variability=\"fixed\" initial=\"exact\"";
      case Kind::parameter:
      case Kind::malfunction:
        return " causality=\"parameter\" variability=\"tunable\" initial=\"exact\"";
      case Kind::operation:
      case Kind::undriven_event:
        return " causality=\"input\" variability=\"discrete\"";
      case Kind::event:
        return " causality=\"output\" variability=\"discrete\" initial=\"calculated\"";
      case Kind::output:
        return " causality=\"local\" variability=\"continuous\" initial=\"calculated\"";
      default:
        return " causality=\"local\" variability=\"discrete\" initial=\"calculated\"";
    }
  }

  std::string description(const Variable& v) const {
    switch (v.kind) {
      case Kind::seed:
        return "all random times are drawn from it";
      case Kind::operation:
      case Kind::other_operation:
        return symbol_text("operation", v.of);
      case Kind::undriven_event:
        return fmt::format("sets {}, which no device, sensor or condition drives", symbols_[2 * std::size_t{v.of}]);
      case Kind::event:
        return symbol_text("event", v.of);
      case Kind::state:
        return "the state in which it is settled, or from which it moves";
      case Kind::moving:
        return "whether it moves";
      case Kind::parts:
        return "the number of parts there";
      case Kind::output:
      case Kind::parameter:
        return std::string(tables::value_kind_name(tables_.values.rows[value_of(v)].kind));
      case Kind::malfunction:
        return "malfunction: true starts it, false ends it";
      case Kind::active:
        return "whether the malfunction is active";
      case Kind::short_pulses:
        return "pulses of events that were shorter than a step, so far";
      case Kind::violations:
        return "violations of requirements, so far";
    }
    return "";
  }

  /// `event at X0001: clamp is closed`
  std::string symbol_text(std::string_view direction, std::uint32_t symbol) const {
    std::string text(direction);
    if (const std::string_view address = symbols_[2 * std::size_t{symbol} + 1]; !address.empty()) {
      text.append(" at ").append(address);
    }
    if (const std::string_view comment = plant_.symbols[symbol].row->comment; !comment.empty()) {
      text.append(": ").append(comment);
    }
    return text;
  }

  std::uint32_t value_of(const Variable& v) const { return v.kind == Kind::parameter ? v.of : value_of_output_[v.of]; }
  static bool is_value(const Variable& v) { return v.kind == Kind::parameter || v.kind == Kind::output; }

  std::string unit(const Variable& v) const {
    if (!is_value(v)) return "";
    const std::string_view unit = values_[2 * std::size_t{value_of(v)} + 1];
    return unit.empty() ? "" : attribute("unit", unit);
  }

  /// The least and the greatest number, if they are narrower than the base type.
  std::string range(const Variable& v) const {
    if (is_value(v)) {
      const tables::ValueRow& row = tables_.values.rows[value_of(v)];
      return (std::isfinite(row.min) ? attribute("min", row.min) : "") +
             (std::isfinite(row.max) ? attribute("max", row.max) : "");
    }
    if (v.kind == Kind::seed) return " min=\"0\"";
    const bool of_symbol = v.kind == Kind::operation || v.kind == Kind::other_operation || v.kind == Kind::event ||
                           v.kind == Kind::undriven_event;
    if (!of_symbol) return "";
    const condition::TypeInfo& type = condition::info_of(tables_.symbols[v.of].type());
    if (type.kind == NumberKind::real || type.bits == 64) return "";
    if (type.kind == NumberKind::unsigned_integer)
      return attribute("min", 0.0) + attribute("max", std::ldexp(1.0, type.bits) - 1);
    const double half = std::ldexp(1.0, type.bits - 1);
    return attribute("min", -half) + attribute("max", half - 1);
  }

  /// Which variables are unknown, by their numbers from 1: the outputs, also in the initialization mode. None depends
  /// on an input before the next step.
  void structure() {
    xml_.open("ModelStructure");
    for (const char* const list : {"Outputs", "InitialUnknowns"}) {
      bool any = false;
      for (std::size_t v = 0; v < variables_.all().size(); ++v) {
        if (variables_.all()[v].kind != Kind::event) continue;
        if (!std::exchange(any, true)) xml_.open(list);
        xml_.line(fmt::format("<Unknown index=\"{}\" dependencies=\"\"/>", v + 1));
      }
      if (any) xml_.close(list);
    }
    xml_.close("ModelStructure");
  }

  const model::PlantModel& plant_;
  const tables::PlantTables& tables_;
  const Variables& variables_;
  fmi::Instance instance_;  ///< in the initial state
  std::vector<std::string_view> units_;
  std::vector<std::string_view> states_;
  std::vector<std::string_view> symbols_;  ///< name and address of each
  std::vector<std::string_view> values_;   ///< name and unit of each
  std::vector<std::uint32_t> value_of_output_;
  std::vector<std::uint32_t> first_unit_;  ///< by type; kNone: no unit has it
  Xml xml_;
};

}  // namespace

std::string model_description(const model::PlantModel& plant, const tables::PlantTables& tables,
                              const fmi::Variables& variables, const std::string& identifier) {
  return Description(plant, tables, variables).text(identifier);
}

}  // namespace symplant::fmu
