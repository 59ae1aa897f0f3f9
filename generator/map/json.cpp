// The map of links as JSON.
#include <fmt/format.h>

#include <string>

#include "map/channels.hpp"
#include "map/drivers.hpp"
#include "map/formats.hpp"
#include "map/texts.hpp"
#include "read/types/data_types.hpp"
#include "symplant/link/status_fields.hpp"
#include "view/json_writer.hpp"

namespace symplant::map {
namespace {

class JsonMap {
 public:
  JsonMap(const LinkView& view, view::JsonWriter& out) : view_(view), out_(out) {}

  void write() {
    out_.begin_object();
    out_.member("controller", view_.controller());
    member_or_null("url", !view_.choice.url.empty(), [&] { out_.value(view_.choice.url); });
    out_.member("server", view_.is_server());
    out_.key("symbols");
    out_.begin_array();
    view_.for_each_symbol([&](std::uint32_t symbol) { write_symbol(symbol); });
    out_.end_array();
    if (view_.is_server()) write_server();
    out_.end_object();
  }

 private:
  template <typename Write>
  void member_or_null(std::string_view key, bool has, Write write) {
    out_.key(key);
    if (has) {
      write();
    } else {
      out_.null();
    }
  }
  void text_or_null(std::string_view key, const std::optional<std::string>& text) {
    member_or_null(key, text.has_value(), [&] { out_.value(*text); });
  }

  void write_symbol(std::uint32_t index) {
    const model::PlantModel& plant = view_.of->plant;
    const model::Symbol& symbol = plant.symbols[index];
    out_.begin_object();
    out_.member("symbol", symbol.name());
    out_.member("list", plant.list_of(symbol).name());
    out_.member("row", symbol.row->line);
    out_.member("address", symbol.row->vendor_address);
    out_.member("iec", symbol.row->iec_address);
    out_.member("type", read::data_type_name(symbol.type));
    out_.member("direction", symbol.direction == tables::Direction::operation ? "operation" : "event");
    out_.member("inverted", symbol.inverted);
    const link::MappedSymbol* const mapped = view_.mapped[index];
    member_or_null("on_link", mapped != nullptr, [&] { write_mapped(*mapped); });
    text_or_null("driven_by", driven_by(view_, index));
    text_or_null("moves", moved_device(view_, index));
    out_.key("drives");
    out_.array(driven_things(view_, index), [&](const std::string& thing) { out_.value(thing); });
    out_.key("read_by");
    out_.array(readers_of(view_, index), [&](const std::string& reader) { out_.value(reader); });
    out_.end_object();
  }

  void write_mapped(const link::MappedSymbol& mapped) {
    out_.begin_object();
    out_.member("location", mapped.location);
    if (view_.is_server()) {
      const link::modbus::IoPoint& point = *view_.points[mapped.symbol];
      out_.member("table", link::modbus::table_name(point.table));
      out_.member("number", point.number);
      out_.member("count", point.width);
      out_.member("modicon", modicon_text(point));
    }
    member_or_null("word_order", view_.words(mapped.symbol) > 1, [&] { out_.value(order_key(mapped.word_order)); });
    member_or_null("on_loss", view_.is_operation(mapped.symbol),
                   [&] { out_.value(on_loss_text(view_.of->tables, mapped)); });
    out_.end_object();
  }

  void write_server() {
    const link::modbus::IoMap& map = view_.served();
    out_.key("sizes");
    out_.begin_object();
    for (std::size_t t = 0; t < link::modbus::kTables; ++t) {
      out_.member(link::modbus::table_name(static_cast<link::modbus::Table>(t)), map.sizes[t]);
    }
    out_.end_object();
    out_.member("word_order", order_key(view_.choice.settings.word_order));
    out_.key("channels");
    out_.array(channels_of(map), [&](const Channel& channel) {
      out_.begin_object();
      out_.member("carries", channel.part_name());
      out_.member("function", channel.function());
      out_.member("table", link::modbus::table_name(channel.table));
      out_.member("start", channel.first);
      out_.member("count", channel.count);
      out_.end_object();
    });
    member_or_null("status_block", map.status_block.has_value(), [&] { write_status_block(*map.status_block); });
    member_or_null("watchdog", map.watchdog.has_value(), [&] { out_.value(*map.watchdog); });
    out_.member("map_hash", fmt::format("{:016x}", link::modbus::map_hash(view_.of->tables, map)));
  }

  void write_status_block(std::uint32_t first) {
    out_.array(link::kStatusFields, [&](const link::StatusField& field) {
      out_.begin_object();
      out_.member("name", field.name);
      out_.member("number", first + field.first);
      out_.member("count", field.words);
      out_.member("meaning", field.meaning);
      out_.end_object();
    });
  }

  static std::string_view order_key(link::WordOrder order) {
    return order == link::WordOrder::low_first ? "low-first" : "high-first";
  }

  const LinkView& view_;
  view::JsonWriter& out_;
};

}  // namespace

FormatFault write_json(std::span<const LinkView> views, base::TextSink& sink) {
  view::JsonWriter out(sink, view::JsonWriter::Form::indented);
  out.begin_object();
  out.member("symplant_map", 1);
  out.member("plant", views.front().of->tables.name);
  out.key("links");
  out.array(views, [&](const LinkView& view) { JsonMap(view, out).write(); });
  out.end_object();
  out.finish();
  sink.put("\n");
  return std::nullopt;
}

}  // namespace symplant::map
