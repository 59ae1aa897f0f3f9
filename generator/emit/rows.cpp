// Tables of the engine as rows of generated code.
#include "emit/rows.hpp"

#include <array>
#include <map>
#include <string_view>

#include "emit/model_text.hpp"
#include "emit/row_text.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {

std::string_view data_type_name(tables::DataType type) {
  static constexpr std::array<std::string_view, 15> kNames{"boolean", "sint",  "int_",  "dint",  "lint",
                                                           "usint",   "uint",  "udint", "ulint", "byte",
                                                           "word",    "dword", "lword", "real",  "lreal"};
  return kNames[static_cast<std::size_t>(type)];
}

namespace {

constexpr std::array<std::string_view, 4> kFormNames{"none", "number", "other", "internal"};

/// The name of the constant for a symbol kind: direction, type, form of the address, moved or free, inverted.
std::string kind_name(const tables::SymbolRow& row) {
  std::string name = row.direction() == tables::Direction::operation ? "kOperation_" : "kEvent_";
  name += data_type_name(row.type());
  name.append("_").append(kFormNames[static_cast<std::size_t>(row.form())]);
  name.append(row.moved() ? "_moved" : "_free");
  return row.inverted() ? name.append("_inverted") : name;
}

std::map<tables::SymbolKind, std::string> kind_names(const lower::EngineTables& tables) {
  std::map<tables::SymbolKind, std::string> names;
  const tables::SymbolRow* last = nullptr;
  for (const tables::SymbolRow& row : tables.symbols) {
    if (last != nullptr && last->kind == row.kind) continue;
    last = &row;
    std::string& name = names[row.kind];
    if (name.empty()) name = kind_name(row);
  }
  return names;
}

/// Iterates over the texts of a blob.
class Texts {
 public:
  explicit Texts(std::string_view blob) : rest_(blob) {}
  std::string_view next() {
    const std::string_view text = rest_.substr(0, rest_.find('\0'));
    rest_.remove_prefix(text.size() + 1);
    return text;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

}  // namespace

std::string_view direction_name(tables::Direction direction) {
  return direction == tables::Direction::operation ? "operation" : "event";
}

void unit_rows(RowWriter& rows, const lower::EngineTables& tables) {
  Texts names(tables.unit_names);
  for (const tables::UnitRow& row : tables.units) {
    rows.text("    {").numbers(unsigned{row.type}, unsigned{row.initial}, unsigned{row.general}, row.operation_bit);
    rows.text(", ").numbers(row.event_bit, row.times).text("},  // ").comment(names.next()).text("\n");
  }
}

std::string time_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const tables::TransitionTimes& row : tables.times) {
    bare_row(rows, row).text("\n");
  }
  return rows.take();
}

std::string kind_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const auto& [kind, name] : kind_names(tables)) {
    const tables::SymbolRow row{0, 0, 0, 0, kind};
    rows.text("constexpr auto ").text(name).text(" = tables::symbol_kind(tables::DataType::");
    rows.text(data_type_name(row.type())).text(", tables::Direction::");
    rows.text(direction_name(row.direction())).text(", tables::AddressForm::");
    rows.text(kFormNames[static_cast<std::size_t>(row.form())]).text(row.moved() ? ", true" : ", false");
    rows.text(row.inverted() ? ", true);\n" : ");\n");
  }
  return rows.take();
}

void symbol_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant) {
  const auto kinds = kind_names(tables);
  auto kind = kinds.begin();
  std::size_t list = 0;
  std::string list_name;
  Texts names(tables.symbol_names);
  for (std::size_t i = 0; i < tables.symbols.size(); ++i) {
    for (; list < tables.lists.size() && tables.lists[list].first_symbol == i; ++list) {
      list_name = ", " + comment_text(plant.lists[list].name()) + ":";
    }
    const tables::SymbolRow& row = tables.symbols[i];
    rows.text("    {").number(row.index).text(", ");
    if (row.unit == tables::kNone) {
      rows.text("kFree");
    } else {
      rows.number(row.unit);
    }
    if (kind->first != row.kind) kind = kinds.find(row.kind);
    rows.text(", ").number(row.number).text(", ").number(row.row).text(", ").text(kind->second).text("},  // ");
    rows.comment(names.next()).text(list_name).number(row.row).text("\n");
    names.next();  // its address
  }
}

std::string list_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.lists.size(); ++i) {
    const tables::SymbolListRow& row = tables.lists[i];
    rows.text("    {").numbers(row.first_symbol, row.controller).text("},  // ").comment(plant.lists[i].name());
    const std::string& controller = plant.controllers[row.controller];
    if (!controller.empty()) rows.text(" of ").comment(controller);
    rows.text("\n");
  }
  return rows.take();
}

void initial_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant) {
  for (const tables::InitialValue& row : tables.initial_values) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text("\n");
  }
}

std::string shared_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::SharedAddress& row : tables.shared_addresses) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text(" follows ");
    rows.comment(plant.symbols[row.leader].name()).text("\n");
  }
  return rows.take();
}

std::string type_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                      const std::vector<std::string>& classes, const std::string& name_space) {
  RowWriter rows;
  for (std::size_t t = 0; t < classes.size(); ++t) {
    rows.text("    tables::row_of<");
    const model::Unit& unit = plant.units[tables.types[t].example];
    if (unit.has_behaviour()) {
      rows.text("::").text(name_space).text("::").text(text::identifier(unit.described->behaviour)).text(", ");
    }
    rows.text("::").text(name_space).text("::").text(classes[t]).text(">(),\n");
  }
  return rows.take();
}

std::string random_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  const std::vector<std::string> readers = random_time_readers(tables, plant);
  for (std::size_t i = 0; i < tables.random_times.size(); ++i) {
    row_text(rows, tables.random_times[i]).text("-").number(i + 1).text(": ").comment(readers[i]).text("\n");
  }
  return rows.take();
}

std::string disable_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::DisableRow& row : tables.disables) {
    const model::Unit& by = plant.units[row.by];
    row_text(rows, row).text("l_disable of ").comment(by.path).text(" in ");
    rows.comment(by.states[row.state].name).text(": ").comment(plant.units[row.unit].path).text("\n");
  }
  return rows.take();
}

void name_rows(RowWriter& rows, const std::string& blob, int per_line) {
  int on_line = 0;
  for (Texts texts(blob); !texts.at_end();) {
    rows.text(on_line == 0 ? "    \"" : " \"").literal(texts.next()).text("\\0\"");
    on_line = (on_line + 1) % per_line;
    if (on_line == 0 || texts.at_end()) rows.text("\n");
  }
}

void symbol_constant_rows(RowWriter& rows, const lower::EngineTables& tables) {
  const auto each = [&](auto act) {
    std::size_t number = 0;
    for (Texts texts(tables.symbol_names); !texts.at_end(); ++number) {
      act(number, texts.next());
      texts.next();  // its address
    }
  };
  // The names are unique when case is ignored: if all of them are identifiers, no two enumerators can be equal.
  bool plain = true;
  each([&](std::size_t, std::string_view name) { plain = plain && text::is_identifier(name); });
  text::IdentifierScope scope;
  each([&](std::size_t number, std::string_view name) {
    rows.text("  ");
    if (plain) {
      rows.text(name);
    } else {
      rows.text(scope.unique(name));
    }
    rows.text(" = ").number(number).text(",\n");
  });
}

}  // namespace symplant::emit
