// Makes the nodes of the server.
#include "symplant/link/opc_ua/address_space.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "symplant/link/opc_ua/engineering_units.hpp"
#include "symplant/link/opc_ua/server_nodes.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

namespace {

using Kind = Variable::Kind;

/// The unit of a number and its range; no unit: empty.
struct Quantity {
  std::string_view unit;
  double low = -tables::kInfinity;
  double high = tables::kInfinity;

  bool has_range() const noexcept { return low > -tables::kInfinity && high < tables::kInfinity; }
};

UA_LocalizedText text_of_nodes(std::string_view text) noexcept { return {UA_STRING_NULL, view_of(text)}; }

class Builder {
 public:
  Builder(UA_Server* server, const PlantNodes& plant, const NodeCallbacks& callbacks)
      : server_(server),
        plant_(plant),
        callbacks_(callbacks),
        symbols_(tables::split_names(plant.tables.symbol_names)),
        units_(tables::split_names(plant.tables.unit_names)),
        values_(tables::split_names(plant.tables.values.names)) {
    for (const tables::SignalRow& signal : plant.tables.values.signals) signals_.emplace(signal.symbol, &signal);
  }

  UA_StatusCode build() {
    add_plant();
    for (std::uint32_t unit = 0; unit < units_.size(); ++unit) add_device(unit);
    for_variable_nodes(plant_, [this](Variable& variable, const std::string& id) { add_variable(variable, id); });
    add_methods();
    return status_;
  }

 private:
  void note(UA_StatusCode status) noexcept {
    if (status_ == UA_STATUSCODE_GOOD) status_ = status;
  }

  void add_object(const std::string& id, const std::string& parent, std::string_view name, std::uint32_t type) {
    UA_ObjectAttributes attributes = UA_ObjectAttributes_default;
    attributes.displayName = text_of_nodes(name);
    const UA_NodeId above =
        parent.empty() ? UA_NODEID_NUMERIC(0, UA_NS0ID_OBJECTSFOLDER) : string_node(kPlantNamespace, parent);
    const std::uint32_t reference =
        type == UA_NS0ID_FOLDERTYPE || parent.empty() ? UA_NS0ID_ORGANIZES : UA_NS0ID_HASCOMPONENT;
    note(UA_Server_addObjectNode(server_, string_node(kPlantNamespace, id), above, UA_NODEID_NUMERIC(0, reference),
                                 {kPlantNamespace, view_of(name)}, UA_NODEID_NUMERIC(0, type), attributes, nullptr,
                                 nullptr));
  }
  void add_folder(const std::string& id, const std::string& parent, std::string_view name) {
    if (folders_.insert(id).second) add_object(id, parent, name, UA_NS0ID_FOLDERTYPE);
  }

  void add_plant() {
    const std::string plant(kPlantNode);
    add_object(plant, "", plant_.tables.name.empty() ? "plant" : plant_.tables.name, UA_NS0ID_BASEOBJECTTYPE);
    add_property(plant, kPlantNamespace, "ModelHash", std::uint64_t{plant_.model_hash}, UA_TYPES_UINT64);
    if (plant_.tables.values.outputs != 0) add_folder(std::string(kValuesNode), plant, "Values");
    if (plant_.tables.malfunctions.size() != 0) add_folder(std::string(kMalfunctionsNode), plant, "Malfunctions");
  }

  /// The folder of a station, which is made if it is not there.
  std::string station_folder(const Station& station) {
    std::string folder(kPlantNode);
    if (station.line.empty()) return folder;
    std::string line = line_node(station);
    add_folder(line, folder, station.line);
    if (station.process.empty()) return line;
    std::string process = process_node(station);
    add_folder(process, line, station.process);
    return process;
  }

  void add_device(std::uint32_t unit) {
    const Station station = station_of(units_[unit]);
    add_object(device_node(units_[unit]), station_folder(station), station.rest, UA_NS0ID_BASEOBJECTTYPE);
  }

  /// The folder of a symbol that no device has: that of its station, if there are devices in it.
  std::string folder_of(std::string_view symbol) {
    const Station station = station_of(symbol);
    if (!station.process.empty() && folders_.contains(process_node(station))) return process_node(station);
    if (!station.line.empty() && folders_.contains(line_node(station))) return line_node(station);
    std::string other(kOtherNode);
    add_folder(other, std::string(kPlantNode), "other");
    return other;
  }

  template <class T>
  void add_property(const std::string& parent, std::uint16_t ns, std::string_view name, T value, std::size_t type) {
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    attributes.displayName = text_of_nodes(name);
    attributes.dataType = UA_TYPES[type].typeId;
    attributes.valueRank = UA_VALUERANK_SCALAR;
    UA_Variant_setScalar(&attributes.value, &value, &UA_TYPES[type]);
    const std::string id = parent + "/" + std::string(name);
    note(UA_Server_addVariableNode(server_, string_node(kPlantNamespace, id), string_node(kPlantNamespace, parent),
                                   UA_NODEID_NUMERIC(0, UA_NS0ID_HASPROPERTY), {ns, view_of(name)},
                                   UA_NODEID_NUMERIC(0, UA_NS0ID_PROPERTYTYPE), attributes, nullptr, nullptr));
  }

  /// The unit and limits of an output.
  Quantity quantity_of_output(std::uint32_t output) const {
    const auto& rows = plant_.tables.values.rows;
    const auto after = std::upper_bound(rows.begin(), rows.end(), output,
                                        [](std::uint32_t of, const tables::ValueRow& row) { return of < row.output; });
    const auto value = static_cast<std::size_t>(after - rows.begin()) - 1;
    return {values_[2 * value + 1], rows[value].min, rows[value].max};
  }

  /// The unit of a symbol to which a signal writes a value as it is.
  Quantity quantity_of_symbol(std::uint32_t symbol) const {
    const tables::ValueTables& values = plant_.tables.values;
    const auto found = signals_.find(symbol);
    if (found == signals_.end() || found->second->scaled) return {};
    const tables::SignalRow& signal = *found->second;
    const tables::FormulaRow& formula = values.formulas[signal.formula];
    if (formula.steps.count != 1 || formula.inputs.count != 1) return {};
    const tables::FormulaInput& input = values.inputs[formula.inputs.first];
    if (input.kind != tables::FormulaInputKind::output) return {};
    Quantity quantity = quantity_of_output(input.of);
    quantity.low = std::max(quantity.low, signal.low);
    quantity.high = std::min(quantity.high, signal.high);
    return quantity;
  }

  std::uint32_t symbol_of(const Variable& variable) const { return plant_.map.points[variable.of].symbol; }

  Quantity quantity_of(const Variable& variable) const {
    if (variable.kind == Kind::output) return quantity_of_output(variable.of);
    if (variable.kind == Kind::event) return quantity_of_symbol(symbol_of(variable));
    return {};
  }

  std::string description_of(const Variable& variable) const {
    switch (variable.kind) {
      case Kind::operation:
      case Kind::event: {
        const std::string_view address = symbols_[std::size_t{symbol_of(variable)} * 2 + 1];
        std::string text = variable.kind == Kind::operation ? "operation (PLC -> plant)" : "event (plant -> PLC)";
        if (!address.empty()) text.append(", ").append(address);
        return text;
      }
      case Kind::state:
        return "the state in which the device is, or from which it moves";
      case Kind::target:
        return "the state to which the device moves; its state if it does not move";
      case Kind::progress:
        return "of the move, 0 to 1";
      case Kind::plant_time:
        return "in seconds";
      default:
        return {};
    }
  }

  /// Where a variable lies, and its name there.
  struct Location {
    std::string parent;
    std::string_view name;
  };
  Location location_of(const Variable& variable, const std::string& id) {
    switch (variable.kind) {
      case Kind::operation:
      case Kind::event: {
        const std::uint32_t symbol = symbol_of(variable);
        const std::uint32_t unit = plant_.tables.symbols[symbol].unit;
        const std::string_view name = symbols_[std::size_t{symbol} * 2];
        return {unit == tables::kNone ? folder_of(name) : device_node(units_[unit]), name};
      }
      case Kind::output:
        return {std::string(kValuesNode), std::string_view(id).substr(value_node("").size())};
      case Kind::active:
        return {std::string(kMalfunctionsNode), std::string_view(id).substr(malfunction_node("").size())};
      default: {
        const std::size_t slash = id.rfind('/');
        return {id.substr(0, slash), std::string_view(id).substr(slash + 1)};
      }
    }
  }

  void add_variable(Variable& variable, const std::string& id) {
    const Location location = location_of(variable, id);
    const Quantity quantity = quantity_of(variable);
    const std::string description = description_of(variable);
    const bool writable = variable.kind == Kind::operation;
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    attributes.displayName = text_of_nodes(location.name);
    attributes.description = text_of_nodes(description);
    attributes.dataType =
        variable.text != nullptr ? UA_TYPES[UA_TYPES_STRING].typeId : data_type_of(variable.type).typeId;
    attributes.valueRank = UA_VALUERANK_SCALAR;
    attributes.accessLevel = UA_ACCESSLEVELMASK_READ | (writable ? UA_ACCESSLEVELMASK_WRITE : 0);
    UA_Variant_init(&attributes.value);
    if (variable.text != nullptr) {
      UA_Variant_setScalar(&attributes.value, const_cast<UA_String*>(variable.text), &UA_TYPES[UA_TYPES_STRING]);
    } else {
      attributes.value = variable.value.variant();
    }
    const UA_NodeId node = string_node(kPlantNamespace, id);
    note(UA_Server_addNode_begin(server_, UA_NODECLASS_VARIABLE, node, string_node(kPlantNamespace, location.parent),
                                 UA_NODEID_NUMERIC(0, UA_NS0ID_HASCOMPONENT), {kPlantNamespace, view_of(location.name)},
                                 UA_NODEID_NUMERIC(0, type_of(quantity)), &attributes,
                                 &UA_TYPES[UA_TYPES_VARIABLEATTRIBUTES], &variable, nullptr));
    note(UA_Server_setVariableNode_dataSource(server_, node, callbacks_.variable));
    // Before the end of the node: what its type demands would get node ids of the library.
    if (!quantity.unit.empty()) add_quantity(id, quantity);
    note(UA_Server_addNode_finish(server_, node));
  }

  /// A server with a small namespace 0 does not have AnalogUnitType, for which the range is optional.
  std::uint32_t type_of(const Quantity& quantity) const {
    if (quantity.unit.empty()) return UA_NS0ID_BASEDATAVARIABLETYPE;
    if (quantity.has_range()) return UA_NS0ID_ANALOGITEMTYPE;
    UA_NodeClass found{};
    const UA_NodeId with_unit = UA_NODEID_NUMERIC(0, UA_NS0ID_ANALOGUNITTYPE);
    const bool known = UA_Server_readNodeClass(server_, with_unit, &found) == UA_STATUSCODE_GOOD;
    return known ? UA_NS0ID_ANALOGUNITTYPE : UA_NS0ID_BASEDATAVARIABLETYPE;
  }

  void add_quantity(const std::string& id, const Quantity& quantity) {
    const EngineeringUnit unit = engineering_unit(quantity.unit);
    UA_EUInformation information{};
    information.namespaceUri = view_of("http://www.opcfoundation.org/UA/units/un/cefact");
    information.unitId = unit.id;
    information.displayName = text_of_nodes(quantity.unit);
    information.description = text_of_nodes(unit.description);
    add_property(id, 0, "EngineeringUnits", information, UA_TYPES_EUINFORMATION);
    if (quantity.has_range()) add_property(id, 0, "EURange", UA_Range{quantity.low, quantity.high}, UA_TYPES_RANGE);
  }

  void add_method(std::string_view name, UA_MethodCallback callback, std::optional<UA_Argument> input,
                  std::optional<UA_Argument> output) {
    UA_MethodAttributes attributes = UA_MethodAttributes_default;
    attributes.displayName = text_of_nodes(name);
    attributes.executable = true;
    attributes.userExecutable = true;
    const std::string id = std::string(kPlantNode) + "/" + std::string(name);
    note(UA_Server_addMethodNode(server_, string_node(kPlantNamespace, id), string_node(kPlantNamespace, kPlantNode),
                                 UA_NODEID_NUMERIC(0, UA_NS0ID_HASCOMPONENT), {kPlantNamespace, view_of(name)},
                                 attributes, callback, input ? 1 : 0, input ? &*input : nullptr, output ? 1 : 0,
                                 output ? &*output : nullptr, nullptr, nullptr));
  }

  static UA_Argument argument(std::string_view name, std::size_t type, std::string_view description) {
    UA_Argument argument;
    UA_Argument_init(&argument);
    argument.name = view_of(name);
    argument.dataType = UA_TYPES[type].typeId;
    argument.valueRank = UA_VALUERANK_SCALAR;
    argument.description = text_of_nodes(description);
    return argument;
  }

  void add_methods() {
    const UA_Argument name =
        argument("name", UA_TYPES_STRING,
                 "as in plant.json, or an ordinary one: `DEVICE stuck`, `DEVICE slow`, `SYMBOL stuck on`");
    const UA_Argument cycles = argument("cycles", UA_TYPES_UINT32, "the plant is frozen after this number of cycles");
    const UA_Argument frozen =
        argument("frozen", UA_TYPES_BOOLEAN, "whether something else freezes the plant, such as the panel");
    add_method("StartMalfunction", callbacks_.start_malfunction, name, std::nullopt);
    add_method("EndMalfunction", callbacks_.end_malfunction, name, std::nullopt);
    add_method("Freeze", callbacks_.freeze, std::nullopt, std::nullopt);
    add_method("Run", callbacks_.run, std::nullopt, frozen);
    add_method("Step", callbacks_.step, cycles, std::nullopt);
  }

  UA_Server* server_;
  const PlantNodes& plant_;
  const NodeCallbacks& callbacks_;
  std::vector<std::string_view> symbols_;  ///< name and address of each
  std::vector<std::string_view> units_;
  std::vector<std::string_view> values_;                                 ///< name and unit of each
  std::unordered_map<std::uint32_t, const tables::SignalRow*> signals_;  ///< by symbol
  std::set<std::string> folders_;
  UA_StatusCode status_ = UA_STATUSCODE_GOOD;
};

/// `level`, or `BOOM[2]` for an output of a value with several.
std::vector<std::string> output_names(const tables::ValueTables& values) {
  const auto texts = tables::split_names(values.names);
  std::vector<std::string> names;
  for (std::size_t value = 0; value < values.rows.size(); ++value) {
    const std::string name(texts[2 * value]);
    const std::uint32_t outputs = values.rows[value].outputs;
    for (std::uint32_t i = 0; i < outputs; ++i) {
      names.push_back(outputs == 1 ? name : name + "[" + std::to_string(i + 1) + "]");
    }
  }
  return names;
}

}  // namespace

void for_variable_nodes(const PlantNodes& plant, const std::function<void(Variable&, const std::string&)>& visit) {
  const auto symbols = tables::split_names(plant.tables.symbol_names);
  const auto units = tables::split_names(plant.tables.unit_names);
  const auto malfunctions = tables::split_names(plant.tables.malfunctions.names);
  const auto outputs = output_names(plant.tables.values);
  const auto id_of = [&](const Variable& variable) -> std::string {
    switch (variable.kind) {
      case Kind::operation:
      case Kind::event:
        return std::string(symbols[std::size_t{plant.map.points[variable.of].symbol} * 2]);
      case Kind::output:
        return value_node(outputs[variable.of]);
      case Kind::state:
        return device_node(units[variable.of]) + "/state";
      case Kind::target:
        return device_node(units[variable.of]) + "/target";
      case Kind::moving:
        return device_node(units[variable.of]) + "/moving";
      case Kind::progress:
        return device_node(units[variable.of]) + "/progress";
      case Kind::active:
        return malfunction_node(malfunctions[variable.of]);
      case Kind::cycles:
        return std::string(kPlantNode) + "/Cycles";
      case Kind::plant_time:
        return std::string(kPlantNode) + "/PlantTime";
      case Kind::frozen:
        return std::string(kPlantNode) + "/Frozen";
    }
    return {};
  };
  for (Variable& variable : plant.variables) visit(variable, id_of(variable));
}

UA_StatusCode add_plant_nodes(UA_Server* server, const PlantNodes& plant, const NodeCallbacks& callbacks) {
  if (UA_Server_addNamespace(server, plant_uri("urn:symplant:", plant.tables.name).c_str()) != kPlantNamespace) {
    return UA_STATUSCODE_BADINTERNALERROR;
  }
  return Builder(server, plant, callbacks).build();
}

}  // namespace symplant::link::opc_ua
