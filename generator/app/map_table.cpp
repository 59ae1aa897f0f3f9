// The rows of `symplant map`.
#include "app/map_table.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/map_notes.hpp"
#include "diag/visible_text.hpp"
#include "text/utf8.hpp"

namespace symplant::app {
namespace {

constexpr std::size_t kColumns = 9;
constexpr std::size_t kModicon = 5;  ///< shown if the link has Modbus numbers
constexpr std::size_t kWords = 6;    ///< the column of word orders, shown if a number takes several registers
constexpr std::size_t kOnLoss = 7;   ///< shown if symbols differ in it

using Cells = std::array<std::string, kColumns>;

/// The width of a text in columns of a terminal.
std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    width += static_cast<std::size_t>(diag::display_width(point.value));
    at += point.length;
  }
  return width;
}

bool is_operation(const link::IoPoint& point) {
  return point.table == link::Table::coil || point.table == link::Table::holding_register;
}

/// Which columns are not empty in this map.
std::array<bool, kColumns> columns_of(const ShownMap& of, const link::LinkSettings& settings) {
  const link::IoMap& map = of.map;
  std::array<bool, kColumns> shown{};
  shown.fill(true);
  const auto any = [&](auto has) { return std::any_of(map.points.begin(), map.points.end(), has); };
  shown[kModicon] = of.addresses == nullptr;
  shown[kWords] = any([](const link::IoPoint& point) { return point.width > 1; });
  shown[kOnLoss] =
      any([&](const link::IoPoint& point) { return is_operation(point) && point.on_loss != settings.on_loss; });
  return shown;
}

class MapTable {
 public:
  MapTable(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
           const ShownMap& shown)
      : plant_(plant),
        tables_(tables),
        controller_(controller),
        map_(shown),
        shown_(columns_of(shown, plant.links[controller].settings())),
        points_(tables.symbols.size()) {
    for (const link::IoPoint& point : shown.map.points) points_[point.symbol] = &point;
  }

  void write(base::TextSink& sink) {
    for_each_row([&](const Cells& cells) { measure(cells); });
    base::PartCollector out(sink);
    for_each_row([&](const Cells& cells) { out.add(line(cells)); });
    out.finish();
  }

 private:
  template <typename Use>
  void for_each_row(Use use) const {
    use({"row", "symbol", "address", "IEC", map_.addresses == nullptr ? "Modbus" : "in the PLC", "Modicon", "words",
         "on loss", "driven by"});
    for (std::uint32_t i = 0; i < tables_.symbols.size(); ++i) {
      if (plant_.controller_of(plant_.symbols[i]) == controller_) use(cells_of(i));
    }
  }

  Cells cells_of(std::uint32_t index) const {
    const model::Symbol& symbol = plant_.symbols[index];
    const link::IoPoint* point = points_[index];
    const std::string list = plant_.lists.size() == 1 ? "" : diag::visible(plant_.list_of(symbol).name()) + ":";
    const bool wide = point != nullptr && point->width > 1;
    const bool operation = point != nullptr && is_operation(*point);
    return {list + std::to_string(symbol.row->line),
            diag::visible(symbol.name()),
            diag::visible(symbol.row->vendor_address),
            diag::visible(symbol.row->iec_address),
            point == nullptr ? "-" : location_of(*point),
            point == nullptr ? "-" : modicon_text(*point),
            wide ? word_order_text(point->word_order) : "",
            !operation                             ? ""
            : point->on_loss == link::OnLoss::hold ? "holds"
                                                   : "off",
            driver(index)};
  }

  std::string location_of(const link::IoPoint& point) const {
    if (map_.addresses == nullptr) return address_text(point);
    return (*map_.addresses)[static_cast<std::size_t>(&point - map_.map.points.data())];
  }

  /// What drives a symbol; `-` for an event that no device drives.
  std::string driver(std::uint32_t index) const {
    const model::Symbol& symbol = plant_.symbols[index];
    const auto unit_of = [&](const model::Symbol& of) { return std::string(plant_.units[of.unit].path); };
    const bool moved = tables_.symbols[index].moved();
    if (symbol.direction == tables::Direction::operation) {
      return moved ? "the PLC, moves " + unit_of(symbol) : "the PLC, moves nothing";
    }
    if (moved) return unit_of(symbol);
    if (symbol.leader != model::kNone && tables_.symbols[symbol.leader].moved()) {
      return unit_of(plant_.symbols[symbol.leader]);
    }
    return "-";
  }

  void measure(const Cells& cells) {
    for (std::size_t i = 0; i < kColumns; ++i) widths_[i] = std::max(widths_[i], width_of(cells[i]));
  }

  std::string line(const Cells& cells) const {
    std::string line;
    for (std::size_t i = 0; i < kColumns; ++i) {
      if (!shown_[i]) continue;
      line += cells[i];
      line.append(widths_[i] - width_of(cells[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
  }

  const model::PlantModel& plant_;
  const tables::PlantTables& tables_;
  const std::uint32_t controller_;
  const ShownMap map_;
  const std::array<bool, kColumns> shown_;
  std::vector<const link::IoPoint*> points_;  ///< by symbol; null: on no link
  std::array<std::size_t, kColumns> widths_{};
};

}  // namespace

void write_map_table(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
                     const ShownMap& shown, base::TextSink& sink) {
  MapTable(plant, tables, controller, shown).write(sink);
}

}  // namespace symplant::app
