// The table of `symplant map`: where each symbol is, what drives it, and notes.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "diag/visible_text.hpp"
#include "map/drivers.hpp"
#include "map/formats.hpp"
#include "map/notes.hpp"
#include "map/texts.hpp"
#include "text/utf8.hpp"

namespace symplant::map {
namespace {

constexpr std::size_t kColumns = 11;
constexpr std::size_t kModicon = 5;   ///< shown if the link has Modbus numbers
constexpr std::size_t kWords = 6;     ///< the column of word orders, shown if a number takes several registers
constexpr std::size_t kInverted = 7;  ///< shown if a symbol is
constexpr std::size_t kOnLoss = 8;    ///< shown if symbols differ in it

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

/// Which columns are not empty in this map.
std::array<bool, kColumns> columns_of(const LinkView& view) {
  std::array<bool, kColumns> shown{};
  shown.fill(true);
  const auto any = [&](auto has) { return std::any_of(view.map.symbols.begin(), view.map.symbols.end(), has); };
  using Mapped = link::MappedSymbol;
  shown[kModicon] = view.is_server();
  shown[kWords] = any([&](const Mapped& one) { return view.words(one.symbol) > 1; });
  shown[kInverted] = any([&](const Mapped& one) { return view.of->tables.symbols[one.symbol].inverted(); });
  shown[kOnLoss] = any(
      [&](const Mapped& one) { return view.is_operation(one.symbol) && one.on_loss != view.choice.settings.on_loss; });
  return shown;
}

/// A head and one row for each symbol of the link's controller, in columns of equal width. Each row is made twice, once
/// to measure it, so that only one is in memory.
class MapTable {
 public:
  explicit MapTable(const LinkView& view) : view_(view), shown_(columns_of(view)) {}

  void write(base::TextSink& sink) {
    for_each_row([&](const Cells& cells) { measure(cells); });
    base::PartCollector out(sink);
    for_each_row([&](const Cells& cells) { out.add(line(cells)); });
    out.finish();
  }

 private:
  template <typename Use>
  void for_each_row(Use use) const {
    use({"row", "symbol", "address", "IEC", view_.is_server() ? "Modbus" : std::string(view_.map.where), "Modicon",
         "words", "inverted", "on loss", "driven by", "drives"});
    view_.for_each_symbol([&](std::uint32_t symbol) { use(cells_of(symbol)); });
  }

  Cells cells_of(std::uint32_t index) const {
    const model::PlantModel& plant = view_.of->plant;
    const model::Symbol& symbol = plant.symbols[index];
    const link::MappedSymbol* const mapped = view_.mapped[index];
    const std::string list = plant.lists.size() == 1 ? "" : diag::visible(plant.list_of(symbol).name()) + ":";
    const bool wide = mapped != nullptr && view_.words(index) > 1;
    const bool operation = mapped != nullptr && view_.is_operation(index);
    const bool numbered = mapped != nullptr && view_.is_server();
    return {list + std::to_string(symbol.row->line),
            diag::visible(symbol.name()),
            diag::visible(symbol.row->vendor_address),
            diag::visible(symbol.row->iec_address),
            mapped == nullptr ? "-" : mapped->location,
            numbered ? modicon_text(*view_.points[index]) : "-",
            wide ? word_order_text(mapped->word_order) : "",
            symbol.inverted ? "inverted" : "",
            operation ? on_loss_text(view_.of->tables, *mapped) : "",
            driver_text(view_, index),
            drives_text(view_, index)};
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

  const LinkView& view_;
  const std::array<bool, kColumns> shown_;
  std::array<std::size_t, kColumns> widths_{};
};

}  // namespace

FormatFault write_table(std::span<const LinkView> views, base::TextSink& sink) {
  for (const LinkView& view : views) {
    if (view.of->plant.controllers.size() > 1) {
      const std::string& called = view.controller();
      sink.put(&view == views.data() ? "" : "\n");
      sink.put(called.empty() ? "the controller without a name" : "controller " + diag::visible(called));
      sink.put("\n");
    }
    MapTable(view).write(sink);
    sink.put(map_notes(view));
  }
  return std::nullopt;
}

}  // namespace symplant::map
