// The data of the page: symbols, devices, and the structures and layouts that devices share.
#include "view/html_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "elements/malfunction/words.hpp"
#include "elements/material/html.hpp"
#include "elements/requirement/words.hpp"
#include "elements/value/html.hpp"
#include "model/classify.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/digest.hpp"
#include "view/cross_references.hpp"
#include "view/html_kinds.hpp"
#include "view/json_writer.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using diag::visible;
using model::kNone;

/// Makes JSON safe for the inside of a `<script>` element, part by part.
class ScriptSink final : public base::TextSink {
 public:
  explicit ScriptSink(base::TextSink& sink) : sink_(sink) {}
  void put(std::string_view part) override { sink_.put(diag::script_json(part)); }

 private:
  base::TextSink& sink_;
};

class DataWriter {
 public:
  DataWriter(const Scene& scene, JsonWriter& json)
      : scene_(scene), plant_(scene.plant), references_(cross_references(scene.plant)), json_(json) {}

  void write() {
    number_units_and_symbols();
    PageKinds kinds(plant_);
    kinds_.reserve(scene_.units.size());
    for (const std::uint32_t unit : scene_.units) kinds_.push_back(kinds.of(plant_.units[unit]));
    json_.begin_object();
    write_head();
    kinds.write(json_);
    json_.key("units");
    json_.array(scene_.units, [&](std::uint32_t unit) { write_unit(unit); });
    json_.key("requirements");
    json_.array(plant_.requirements, [&](const model::Requirement& requirement) {
      json_.row(visible(requirement.name), visible(requirement_text(requirement, plant_)));
    });
    write_page_material(scene_, json_);
    write_page_values(scene_, unit_positions_, json_);
    write_malfunctions();
    json_.key("symbols");
    json_.begin_array();
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (symbol_positions_[i] >= 0) write_symbol(plant_.symbols[i]);
    }
    json_.end_array();
    json_.end_object();
  }

 private:
  /// If all devices are shown, all symbols are, too; otherwise only the symbols of the devices shown.
  void number_units_and_symbols() {
    unit_positions_.assign(plant_.units.size(), -1);
    for (std::size_t i = 0; i < scene_.units.size(); ++i) unit_positions_[scene_.units[i]] = static_cast<int>(i);
    const bool all = scene_.units.size() == plant_.units.size();
    std::vector<bool> shown(plant_.symbols.size(), all);
    for (const std::uint32_t unit : scene_.units) {
      for (const auto* side :
           {&plant_.units[unit].operations, &plant_.units[unit].events, &plant_.units[unit].values}) {
        for (const std::uint32_t symbol : *side) shown[symbol] = true;
      }
    }
    symbol_positions_.assign(plant_.symbols.size(), -1);
    int next = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (shown[i]) symbol_positions_[i] = next++;
    }
  }

  void write_malfunctions() {
    if (plant_.malfunctions.empty()) return;
    json_.key("malfunctions");
    json_.array(plant_.malfunctions, [&](const model::Malfunction& malfunction) {
      json_.row(visible(malfunction.name), visible(malfunction_text(malfunction, plant_)));
    });
  }

  void write_head() {
    json_.member("plant", visible(plant_.name));
    json_.member("hash", fmt::format("{:016x}", tables::model_hash(scene_.tables.tables())));
    json_.key("lists");
    json_.array(plant_.lists, [&](const model::PlantList& list) {
      const std::string& controller = plant_.controllers[list.controller];
      json_.value(visible(list.name() + (controller.empty() ? "" : " of " + controller)));
    });
    json_.key("types");
    json_.begin_array();
    for (int type = 0; type <= static_cast<int>(tables::DataType::lreal); ++type) {
      json_.value(model::data_type_name(static_cast<tables::DataType>(type)));
    }
    json_.end_array();
    json_.key("reasons");
    json_.begin_array();
    for (std::size_t reason = 0; reason < name::kAccounts; ++reason) {
      json_.value(unmodelled_reason(static_cast<model::Account>(reason)));
    }
    json_.end_array();
    json_.key("internal");
    json_.begin_array();
    for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
      json_.row(model::internal_reason_text(static_cast<model::InternalReason>(i)), plant_.internal[i]);
    }
    json_.end_array();
  }

  /// The elements are in the order of the index constants of page.js.
  void write_symbol(const model::Symbol& symbol) {
    json_.begin_array();
    json_.value(visible(symbol.name()));
    json_.value(symbol.row->line);
    json_.value(symbol.list);
    json_.value(symbol.direction == tables::Direction::event ? 1 : 0);
    json_.value(static_cast<int>(symbol.type));
    json_.value(visible(symbol.row->vendor_address));
    json_.value(visible(symbol.row->iec_address));
    json_.value(symbol.initial == 0 ? std::string() : value_text(symbol.type, symbol.initial));
    const std::uint32_t unit = symbol.unit_of_device();
    json_.value(unit == kNone ? -1 : unit_positions_[unit]);
    json_.value(static_cast<int>(symbol.account));
    if (symbol.leader != kNone) json_.value(visible(plant_.symbols[symbol.leader].name()));
    json_.end_array();
  }

  void write_positions(std::string_view key, const std::vector<std::uint32_t>& symbols) {
    json_.key(key);
    json_.array(symbols, [&](std::uint32_t symbol) { json_.value(symbol_positions_[symbol]); });
  }

  void write_unit(std::uint32_t index) {
    const model::Unit& unit = plant_.units[index];
    const model::SymbolReading& reading = plant_.symbols[unit.first_symbol()].reading;
    json_.begin_object();
    json_.member("path", visible(unit.path));
    json_.member("line", visible(reading.line()));
    json_.member("process", visible(reading.process()));
    json_.member("device", visible(unit.device));
    if (unit.facet != nullptr && !unit.facet->name.empty()) json_.member("facet", visible(unit.facet->name));
    json_.member("kind", kinds_[static_cast<std::size_t>(unit_positions_[index])]);
    json_.member("initial", unit.initial);
    json_.member("why", initial_reason(unit.initial_from));
    write_positions("operations", unit.operations);
    write_positions("events", unit.events);
    if (unit.described != nullptr && !unit.described->type.empty()) json_.member("type", visible(unit.described->type));
    if (!unit.values.empty()) write_positions("values", unit.values);
    write_conditions(unit);
    write_relations(unit, index);
    json_.end_object();
  }

  void write_conditions(const model::Unit& unit) {
    if (unit.first_input != 0) {
      json_.key("conditions");
      json_.begin_array();
      for (std::uint32_t i = 0; i < unit.first_input; ++i) {
        json_.value(visible(model::condition_text(unit.conditions[i], plant_)));
      }
      json_.end_array();
    }
    if (!unit.has_behaviour()) return;
    json_.member("behaviour", visible(unit.described->behaviour));
    json_.key("inputs");
    json_.begin_array();
    for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
      json_.row(visible(unit.input_names[i - unit.first_input]),
                visible(model::condition_text(unit.conditions[i], plant_)));
    }
    json_.end_array();
  }

  void write_relations(const model::Unit& unit, std::uint32_t index) {
    const bool disables =
        std::any_of(unit.disables.begin(), unit.disables.end(), [](const auto& others) { return !others.empty(); });
    if (disables) {
      json_.key("disables");
      json_.begin_array();
      for (std::size_t s = 0; s < unit.disables.size(); ++s) {
        for (const std::uint32_t other : unit.disables[s]) json_.row(s, visible(plant_.units[other].path));
      }
      json_.end_array();
    }
    if (const auto& disabled_by = references_.disabled_by[index]; !disabled_by.empty()) {
      json_.key("disabledBy");
      json_.array(disabled_by, [&](const Disabler& by) {
        json_.row(visible(plant_.units[by.unit].path), visible(plant_.units[by.unit].states[by.state].name));
      });
    }
    if (const auto& requirements = references_.requirements[index]; !requirements.empty()) {
      json_.key("requirements");
      json_.array(requirements, [&](std::uint32_t requirement) { json_.value(requirement); });
    }
  }

  const Scene& scene_;
  const model::PlantModel& plant_;
  const CrossReferences references_;
  JsonWriter& json_;
  std::vector<std::uint32_t> kinds_;   // by index in the page
  std::vector<int> unit_positions_;    // index in the page; -1 if the unit is not shown
  std::vector<int> symbol_positions_;  // index in the page; -1 if the symbol is not shown
};

}  // namespace

void html_data(const Scene& scene, base::TextSink& sink) {
  ScriptSink script(sink);
  JsonWriter json(script, JsonWriter::Form::compact);
  DataWriter(scene, json).write();
  json.finish();
}

}  // namespace symplant::view
