// The map of links as a CSV table: a row for each symbol, part of the status block, watchdog and channel.
#include <array>
#include <string>
#include <string_view>

#include "convert/cells.hpp"
#include "map/channels.hpp"
#include "map/drivers.hpp"
#include "map/formats.hpp"
#include "map/texts.hpp"
#include "read/types/data_types.hpp"
#include "symplant/link/status_fields.hpp"

namespace symplant::map {
namespace {

/// The cells of a row; numbers are empty where they do not apply.
struct CsvRow {
  std::string_view kind;
  std::string name, list, row, address, iec, type, table, number, count, modicon, location, word_order, function,
      inverted, on_loss, driven_by, drives;
};

constexpr std::string_view kHeader =
    "kind,controller,name,list,row,address,IEC,type,table,number,count,Modicon,location,word order,function code,"
    "inverted,on loss,driven by,drives\n";

class CsvMap {
 public:
  CsvMap(const LinkView& view, base::PartCollector& out) : view_(view), out_(out) {}

  void write() {
    view_.for_each_symbol([&](std::uint32_t symbol) { add_symbol(symbol); });
    if (!view_.is_server()) return;
    const link::modbus::IoMap& map = view_.served();
    if (map.status_block) add_status_block(*map.status_block);
    if (map.watchdog) {
      CsvRow row = registers("watchdog", link::modbus::Table::holding_register, *map.watchdog, 1);
      row.driven_by = "the PLC";
      add(row);
    }
    for (const Channel& channel : channels_of(map)) {
      CsvRow row = registers("channel", channel.table, channel.first, channel.count);
      row.name = channel.access();
      row.function = std::to_string(channel.function());
      add(row);
    }
  }

 private:
  static CsvRow registers(std::string_view kind, link::modbus::Table table, std::uint32_t first, std::uint32_t count) {
    CsvRow row;
    row.kind = kind;
    row.table = link::modbus::table_name(table);
    row.number = std::to_string(first);
    row.count = std::to_string(count);
    return row;
  }

  void add_symbol(std::uint32_t index) {
    const model::PlantModel& plant = view_.of->plant;
    const model::Symbol& symbol = plant.symbols[index];
    const link::MappedSymbol* const mapped = view_.mapped[index];
    CsvRow row;
    if (mapped != nullptr) {
      if (view_.is_server()) {
        const link::modbus::IoPoint& point = *view_.points[index];
        row = registers("", point.table, point.number, point.width);
        row.modicon = modicon_text(point);
      }
      row.location = mapped->location;
      if (view_.words(index) > 1) row.word_order = word_order_text(mapped->word_order);
      if (view_.is_operation(index)) row.on_loss = on_loss_text(view_.of->tables, *mapped);
    }
    row.kind = "symbol";
    row.name = symbol.name();
    row.list = plant.list_of(symbol).name();
    row.row = std::to_string(symbol.row->line);
    row.address = symbol.row->vendor_address;
    row.iec = symbol.row->iec_address;
    row.type = read::data_type_name(symbol.type);
    row.inverted = symbol.inverted ? "yes" : "no";
    row.driven_by = driver_text(view_, index);
    row.drives = drives_text(view_, index);
    add(row);
  }

  void add_status_block(std::uint32_t first) {
    for (const link::StatusField& field : link::kStatusFields) {
      CsvRow row = registers("status", link::modbus::Table::input_register, first + field.first, field.words);
      row.name = field.name;
      if (field.words > 1) row.word_order = word_order_text(view_.choice.settings.word_order);
      row.driven_by = "the link";
      add(row);
    }
  }

  void add(const CsvRow& row) {
    std::string text(row.kind);
    for (const std::string_view cell :
         {std::string_view(view_.controller()), std::string_view(row.name), std::string_view(row.list),
          std::string_view(row.row), std::string_view(row.address), std::string_view(row.iec),
          std::string_view(row.type), std::string_view(row.table), std::string_view(row.number),
          std::string_view(row.count), std::string_view(row.modicon), std::string_view(row.location),
          std::string_view(row.word_order), std::string_view(row.function), std::string_view(row.inverted),
          std::string_view(row.on_loss), std::string_view(row.driven_by), std::string_view(row.drives)}) {
      text += ',';
      convert::append_protected_cell(text, cell);
    }
    out_.add(text + "\n");
  }

  const LinkView& view_;
  base::PartCollector& out_;
};

}  // namespace

FormatFault write_csv(std::span<const LinkView> views, base::TextSink& sink) {
  base::PartCollector out(sink);
  out.add(kHeader);
  for (const LinkView& view : views) CsvMap(view, out).write();
  out.finish();
  return std::nullopt;
}

}  // namespace symplant::map
