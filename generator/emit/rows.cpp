// The one writer of rows.
#include "emit/rows.hpp"

#include <array>
#include <map>
#include <string_view>

#include "base/identifier.hpp"
#include "emit/model_text.hpp"
#include "emit/row_writer.hpp"

namespace symplant::emit {

std::string_view data_type_name(core::DataType type) {
  static constexpr std::array<std::string_view, 15> kNames{"boolean", "sint",  "int_",  "dint",  "lint",
                                                           "usint",   "uint",  "udint", "ulint", "byte",
                                                           "word",    "dword", "lword", "real",  "lreal"};
  return kNames[static_cast<std::size_t>(type)];
}

namespace {

constexpr std::array<std::string_view, 3> kFormNames{"none", "number", "other"};

/// The name of a kind's constant: direction, type, form of the address, moved or free.
std::string kind_name(const core::SymbolRow& row) {
  std::string name = row.direction() == core::Direction::operation ? "kOperation_" : "kEvent_";
  name += data_type_name(row.type());
  name.append("_").append(kFormNames[static_cast<std::size_t>(row.form())]);
  return name.append(row.moved() ? "_moved" : "_free");
}

std::map<core::SymbolKind, std::string> kind_names(const lower::EngineTables& tables) {
  std::map<core::SymbolKind, std::string> names;
  for (const core::SymbolRow& row : tables.symbols) {
    std::string& name = names[row.kind];
    if (name.empty()) name = kind_name(row);
  }
  return names;
}

}  // namespace

std::string_view direction_name(core::Direction direction) {
  return direction == core::Direction::operation ? "operation" : "event";
}

std::string unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.units.size(); ++i) {
    const core::UnitRow& row = tables.units[i];
    rows.text("    {").numbers(unsigned{row.type}, unsigned{row.initial}, unsigned{row.rich}, row.operation_bit);
    rows.text(", ").numbers(row.event_bit, row.times).text("},  // ");
    rows.comment(plant.units[i].path).text("\n");
  }
  return rows.take();
}

std::string time_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const core::TransitionTimes& row : tables.times) {
    rows.text("    {").number(row.after).text(", ").number(row.takes).text("},\n");
  }
  return rows.take();
}

std::string kind_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const auto& [kind, name] : kind_names(tables)) {
    const core::SymbolRow row{0, 0, 0, 0, kind};
    rows.text("constexpr auto ").text(name).text(" = core::symbol_kind(core::DataType::");
    rows.text(data_type_name(row.type())).text(", core::Direction::");
    rows.text(direction_name(row.direction())).text(", core::AddressForm::");
    rows.text(kFormNames[static_cast<std::size_t>(row.form())]).text(row.moved() ? ", true);\n" : ", false);\n");
  }
  return rows.take();
}

std::string symbol_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  auto kinds = kind_names(tables);
  std::vector<std::string> lists;
  for (const model::PlantList& list : plant.lists) lists.push_back(list.name());
  for (std::size_t i = 0; i < tables.symbols.size(); ++i) {
    const core::SymbolRow& row = tables.symbols[i];
    rows.text("    {").number(row.index).text(", ");
    if (row.unit == core::kNoUnit) {
      rows.text("kFree");
    } else {
      rows.number(row.unit);
    }
    rows.text(", ").number(row.number).text(", ").number(row.row).text(", ");
    rows.text(kinds[row.kind]).text("},  // ");
    rows.comment(plant.symbols[i].name())
        .text(", ")
        .comment(lists[plant.symbols[i].list])
        .text(":")
        .number(row.row)
        .text("\n");
  }
  return rows.take();
}

std::string list_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.lists.size(); ++i) {
    const core::SymbolListRow& row = tables.lists[i];
    rows.text("    {").numbers(row.first_symbol, row.controller).text("},  // ").comment(plant.lists[i].name());
    const std::string& controller = plant.controllers[row.controller];
    if (!controller.empty()) rows.text(" of ").comment(controller);
    rows.text("\n");
  }
  return rows.take();
}

std::string initial_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const core::InitialValue& row : tables.initial_values) {
    rows.text("    {").number(row.symbol).text(", ").number(row.value).text("U},  // ");
    rows.comment(plant.symbols[row.symbol].name()).text("\n");
  }
  return rows.take();
}

std::string shared_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const core::SharedAddress& row : tables.shared_addresses) {
    rows.text("    {").numbers(row.symbol, row.leader).text("},  // ");
    rows.comment(plant.symbols[row.symbol].name()).text(" follows ").comment(plant.symbols[row.leader].name());
    rows.text("\n");
  }
  return rows.take();
}

std::string type_rows(const std::vector<std::string>& classes, const std::string& name_space) {
  RowWriter rows;
  for (const std::string& name : classes) rows.text("    ::").text(name_space).text("::").text(name).text("::row(),\n");
  return rows.take();
}

std::string random_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  const std::vector<std::string> readers = random_time_readers(tables, plant);
  for (std::size_t i = 0; i < tables.random_times.size(); ++i) {
    const core::RandomTime& row = tables.random_times[i];
    rows.text("    {core::RandomTime::Kind::").text(row.kind == core::RandomTime::Kind::uniform ? "uniform" : "normal");
    rows.text(", ").numbers(row.a, row.b).text("},  // -").number(i + 1).text(": ").comment(readers[i]).text("\n");
  }
  return rows.take();
}

std::string disable_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const core::DisableRow& row : tables.disables) {
    const model::Unit& by = plant.units[row.by];
    rows.text("    {").numbers(row.by, row.unit, unsigned{row.state}).text("},  // l_disable of ").comment(by.path);
    rows.text(" in ").comment(by.states[row.state].name).text(": ").comment(plant.units[row.unit].path).text("\n");
  }
  return rows.take();
}

std::string transition_rows(const lower::Type& type, const model::Unit& example, const model::PlantModel& plant) {
  RowWriter rows;
  for (const core::Transition& row : type.transitions) {
    rows.text("      {").numbers(unsigned{row.from}, unsigned{row.to}).text(", ");
    if (row.on == core::kNoOperation) {
      rows.text("symplant::core::kNoOperation");
    } else if (row.on == core::kSpringWay) {
      rows.text("symplant::core::kSpringWay");
    } else {
      rows.number(unsigned{row.on});
    }
    const bool guarded = row.when != core::kNoCondition;
    if (row.once || guarded || row.timed) {
      rows.text(row.once ? ", true, " : ", false, ");
      guarded ? rows.number(row.when) : rows.text("symplant::core::kNoCondition");
      if (row.timed) rows.text(", true");
    }
    rows.text("},  // ").comment(transition_text(row, example, plant)).text(row.once ? ", once" : "");
    if (guarded) rows.text(", when condition ").number(row.when).text(" of the device holds");
    rows.text("\n");
  }
  return rows.take();
}

std::string name_rows(const std::string& blob, int per_line) {
  RowWriter rows;
  int on_line = 0;
  for (std::size_t at = 0; at < blob.size();) {
    const std::size_t end = blob.find('\0', at);
    rows.text(on_line == 0 ? "    \"" : " \"").literal(std::string_view(blob).substr(at, end - at)).text("\\0\"");
    at = end + 1;
    on_line = (on_line + 1) % per_line;
    if (on_line == 0 || at >= blob.size()) rows.text("\n");
  }
  return rows.take_or("    \"\"");
}

std::string link_rows(const model::Description& description) {
  RowWriter rows;
  for (const model::LinkDescription& link : description.links) {
    rows.text("    {\"").literal(link.controller).text("\", \"").literal(link.url).text("\"},\n");
  }
  return rows.take();
}

std::string device_rows(const model::PlantModel& plant) {
  RowWriter rows;
  base::IdentifierScope scope;
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    rows.text("  ").text(scope.unique(plant.units[i].path, "k")).text(" = ").number(i).text(",\n");
  }
  return rows.take();
}

std::string symbol_constant_rows(const model::PlantModel& plant) {
  RowWriter rows;
  base::IdentifierScope scope;
  for (std::size_t i = 0; i < plant.symbols.size(); ++i) {
    rows.text("  ").text(scope.unique(plant.symbols[i].name(), "k")).text(" = ").number(i).text(",\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
