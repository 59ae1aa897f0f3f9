// The one writer of rows.
#include "emit/rows.hpp"

#include <array>
#include <charconv>
#include <concepts>
#include <map>
#include <string_view>

#include "base/identifier.hpp"
#include "emit/encode.hpp"

namespace symplant::emit {
namespace {

class RowWriter {
 public:
  RowWriter& text(std::string_view text) {
    out_.append(text);
    return *this;
  }
  template <std::integral Number>
  RowWriter& number(Number value) {
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    out_.append(digits.data(), end);
    return *this;
  }
  RowWriter& comment(std::string_view utf8) {
    append_comment(out_, utf8);
    return *this;
  }
  RowWriter& literal(std::string_view bytes) {
    append_literal(out_, bytes);
    return *this;
  }
  /// All rows; `{}` where there is none.
  std::string take() {
    if (out_.empty()) return "    {},";
    out_.pop_back();
    return std::move(out_);
  }
  std::string take_or(std::string_view none) {
    if (out_.empty()) return std::string(none);
    out_.pop_back();
    return std::move(out_);
  }

 private:
  std::string out_;
};

constexpr std::array<std::string_view, 15> kTypeNames{"boolean", "sint",  "int_",  "dint",  "lint",
                                                      "usint",   "uint",  "udint", "ulint", "byte",
                                                      "word",    "dword", "lword", "real",  "lreal"};
constexpr std::array<std::string_view, 3> kFormNames{"none", "number", "other"};

/// The name of a kind's constant: direction, type, form of the address, moved or free.
std::string kind_name(const core::SymbolRow& row) {
  std::string name = row.direction() == core::Direction::operation ? "kOperation_" : "kEvent_";
  name += kTypeNames[static_cast<std::size_t>(row.type())];
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

std::string unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.units.size(); ++i) {
    const core::UnitRow& row = tables.units[i];
    rows.text("    {").number(row.type).text(", ").number(row.operation_bit).text(", ").number(row.event_bit);
    rows.text(", ").number(row.times).text(", ").number(static_cast<unsigned>(row.initial)).text("},  // ");
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
    rows.text(kTypeNames[static_cast<std::size_t>(row.type())]).text(", core::Direction::");
    rows.text(row.direction() == core::Direction::operation ? "operation" : "event").text(", core::AddressForm::");
    rows.text(kFormNames[static_cast<std::size_t>(row.form())]).text(row.moved() ? ", true);\n" : ", false);\n");
  }
  return rows.take_or("");
}

std::string symbol_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  auto kinds = kind_names(tables);
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
    rows.comment(plant.symbols[i].name()).text(", ").comment(tables.list).text(":").number(row.row).text("\n");
  }
  return rows.take();
}

std::string initial_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const core::InitialValue& row : tables.initial_values) {
    rows.text("    {").number(row.symbol).text(", ").number(row.value).text("U},\n");
  }
  return rows.take();
}

std::string shared_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const core::SharedAddress& row : tables.shared_addresses) {
    rows.text("    {").number(row.symbol).text(", ").number(row.leader).text("},\n");
  }
  return rows.take();
}

std::string type_rows(const std::vector<std::string>& classes, const std::string& name_space) {
  RowWriter rows;
  for (const std::string& name : classes) rows.text("    ::").text(name_space).text("::").text(name).text("::row(),\n");
  return rows.take_or("");
}

std::string transition_rows(const lower::Type& type, const model::Unit& example, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < type.transitions.size(); ++i) {
    const core::Transition& row = type.transitions[i];
    rows.text("      {").number(static_cast<unsigned>(row.from)).text(", ").number(static_cast<unsigned>(row.to));
    rows.text(", ");
    if (row.on == core::kNoOperation) {
      rows.text("symplant::core::kNoOperation},  // d_int(").comment(example.states[row.from].name);
    } else {
      rows.number(static_cast<unsigned>(row.on)).text("},  // d_ext(").comment(example.states[row.from].name);
      rows.text(", O_").comment(plant.symbols[example.operations[row.on]].reading.task);
    }
    rows.text(") = ").comment(example.states[row.to].name).text("\n");
  }
  return rows.take_or("");
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

std::string device_rows(const model::PlantModel& plant) {
  RowWriter rows;
  base::IdentifierScope scope;
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    rows.text("  ").text(scope.unique(plant.units[i].path, "k")).text(" = ").number(i).text(",\n");
  }
  return rows.take_or("");
}

std::string symbol_constant_rows(const model::PlantModel& plant) {
  RowWriter rows;
  base::IdentifierScope scope;
  for (std::size_t i = 0; i < plant.symbols.size(); ++i) {
    rows.text("  ").text(scope.unique(plant.symbols[i].name(), "k")).text(" = ").number(i).text(",\n");
  }
  return rows.take_or("");
}

}  // namespace symplant::emit
