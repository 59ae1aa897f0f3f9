// The variables by which a PLC's program uses a map.
#include "map/variables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convert/identifiers.hpp"
#include "map/texts.hpp"
#include "text/ascii.hpp"

namespace symplant::map {

VariableNames::VariableNames(const LinkView& view) : names_(view.mapped.size()) {
  const model::PlantModel& plant = view.of->plant;
  std::vector<std::uint32_t> others;
  for (const link::modbus::IoPoint& point : view.served().points) {
    const std::string name(plant.symbols[point.symbol].name());
    if (convert::is_iec_identifier(name) && take(name)) {
      names_[point.symbol] = name;
    } else {
      others.push_back(point.symbol);
    }
  }
  for (const std::uint32_t symbol : others) {
    names_[symbol] = add(convert::iec_identifier(plant.symbols[symbol].name()));
  }
}

std::string VariableNames::add(const std::string& wanted) {
  std::string name = wanted;
  for (std::size_t next = 2; !take(name); ++next) name = fmt::format("{}_{}", wanted, next);
  return name;
}

bool VariableNames::take(const std::string& name) { return taken_.insert(text::to_lower(name)).second; }

std::string status_name(const link::StatusField& field) {
  std::string name = "PLANT_" + text::to_upper(field.name);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string_view unsigned_type(std::uint32_t words) { return words == 1 ? "UINT" : words == 2 ? "UDINT" : "ULINT"; }

std::string variable_comment(const LinkView& view, const VariableNames& names, const link::modbus::IoPoint& point) {
  const model::Symbol& symbol = view.of->plant.symbols[point.symbol];
  std::string text = view.location(point.symbol);
  if (point.width > 1) text += ", " + word_order_text(point.word_order);
  if (symbol.inverted) text += ", inverted";
  if (names[point.symbol] != symbol.name()) text += fmt::format("; renamed, row {} of the list", symbol.row->line);
  return text;
}

std::string status_comment(const LinkView& view, const link::StatusField& field) {
  if (field.name != "map hash") return std::string(field.meaning);
  return fmt::format("must be 16#{:016X}", link::modbus::map_hash(view.of->tables, view.served()));
}

}  // namespace symplant::map
