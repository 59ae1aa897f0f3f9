// The plant's links as rows of generated code.
#include "elements/link/rows.hpp"

#include "emit/row_writer.hpp"

namespace symplant::emit {
namespace {

std::string_view word_order(link::WordOrder order) {
  switch (order) {
    case link::WordOrder::low_first:
      return "link::WordOrder::low_first";
    case link::WordOrder::high_first:
      return "link::WordOrder::high_first";
    case link::WordOrder::as_link:
      break;
  }
  return "link::WordOrder::as_link";
}

std::string_view on_loss(link::OnLoss what) {
  switch (what) {
    case link::OnLoss::hold:
      return "link::OnLoss::hold";
    case link::OnLoss::zero:
      return "link::OnLoss::zero";
    case link::OnLoss::as_link:
      break;
  }
  return "link::OnLoss::as_link";
}

/// `{.member = value, .member = value}`: the members that differ from their defaults.
class Members {
 public:
  explicit Members(RowWriter& rows) : rows_(rows) { rows_.text("    {"); }

  RowWriter& next(std::string_view name) {
    rows_.text(first_ ? "." : ", .").text(name).text(" = ");
    first_ = false;
    return rows_;
  }
  template <class Number>
  void number(std::string_view name, Number value, Number otherwise) {
    if (value != otherwise) next(name).number(value);
  }
  void place(std::string_view name, std::uint32_t value, std::uint32_t otherwise) {
    if (value == otherwise) return;
    RowWriter& rows = next(name);
    if (value == link::kNowhere) {
      rows.text("link::kNowhere");
    } else {
      rows.number(value);
    }
  }

 private:
  RowWriter& rows_;
  bool first_ = true;
};

void settings_row(RowWriter& rows, std::size_t controller, const model::ControllerLink& link) {
  const link::LinkSettings& set = link.link;
  const link::LinkSettings none;
  Members members(rows);
  if (!link.rows.empty()) members.next("rows").text("links::kLinkRows").number(controller);
  if (set.word_order != none.word_order) members.next("word_order").text(word_order(set.word_order));
  if (set.word_order_given) members.next("word_order_given").text("true");
  if (set.on_loss != none.on_loss) members.next("on_loss").text(on_loss(set.on_loss));
  if (set.plant_on_loss != none.plant_on_loss) {
    members.next("plant_on_loss").text("link::PlantOnLoss::freeze");
  }
  if (set.sizes != none.sizes) {
    members.next("sizes").text("{").numbers(set.sizes[0], set.sizes[1], set.sizes[2], set.sizes[3]).text("}");
  }
  members.number("loss_after", set.loss_after, none.loss_after);
  members.number("resync", set.resync, none.resync);
  members.place("status_block", set.status_block, none.status_block);
  members.place("watchdog", set.watchdog, none.watchdog);
  members.number("watchdog_within", set.watchdog_within, none.watchdog_within);
  members.number("connections", set.connections, none.connections);
  members.number("idle", set.idle, none.idle);
  if (set.clock.symbol != none.clock.symbol) {
    members.next("clock").text("{").numbers(set.clock.symbol, set.clock.unit, set.clock.limit).text("}");
  }
  if (!link.keep.empty()) members.next("keep").text("links::kKeep").number(controller);
  rows.text("},\n");
}

}  // namespace

std::string link_rows(const description::Description& description) {
  RowWriter rows;
  for (const description::LinkDescription& link : description.links) {
    rows.text("    {\"").literal(link.controller).text("\", \"").literal(link.url).text("\"},\n");
  }
  return rows.take();
}

std::string ignored_variables(const description::Description& description) {
  RowWriter rows;
  for (std::size_t i = 0; i < description.programs.size(); ++i) {
    const std::vector<std::string>& ignored = description.programs[i].ignore;
    if (ignored.empty()) continue;
    rows.text("constexpr std::array<std::string_view, ")
        .number(ignored.size())
        .text("> kIgnoredVariables")
        .number(i)
        .text("{");
    for (const std::string& pattern : ignored)
      rows.text(&pattern == &ignored.front() ? "\"" : ", \"").literal(pattern).text("\"");
    rows.text("};\n");
  }
  return rows.take();
}

std::string program_rows(const description::Description& description) {
  RowWriter rows;
  for (std::size_t i = 0; i < description.programs.size(); ++i) {
    const description::ProgramDescription& program = description.programs[i];
    rows.text("    {\"").literal(program.controller).text("\", \"").literal(program.file).text("\", ");
    rows.numbers(program.period, program.delay).text(", symplant::link::OnLoss::");
    rows.text(program.on_loss == link::OnLoss::zero ? "zero" : "hold");
    if (!program.ignore.empty()) rows.text(", kIgnoredVariables").number(i);
    rows.text("},\n");
  }
  return rows.take();
}

std::vector<const description::GivenCheck::Ignore*> ignored_findings(const description::Description& description) {
  std::vector<const description::GivenCheck::Ignore*> entries;
  for (const description::GivenCheck::Ignore& entry : description.check.ignore) {
    if (!entry.finding.empty()) entries.push_back(&entry);
  }
  return entries;
}

std::string ignored_rows(const description::Description& description) {
  RowWriter rows;
  for (const description::GivenCheck::Ignore* entry : ignored_findings(description)) {
    rows.text("    {\"").literal(entry->finding).text("\", \"").literal(entry->symbols).text("\", \"");
    rows.literal(entry->until).text("\"},\n");
  }
  return rows.take();
}

std::string device_view_rows(const model::Layout& layout) {
  RowWriter rows;
  for (const model::DevicePlace& place : layout.devices) {
    rows.text("    {").numbers(place.station, place.x, place.y).text("},\n");
  }
  return rows.take();
}

std::string station_rows(const model::Layout& layout) {
  RowWriter rows;
  for (const model::Station& station : layout.stations) {
    rows.text("    \"").literal(station.line).text("\\0\" \"").literal(station.process).text("\\0\"\n");
  }
  return rows.take();
}

std::string symbol_view_rows(const model::PlantModel& plant) {
  const bool any = std::any_of(plant.symbols.begin(), plant.symbols.end(), [](const model::Symbol& symbol) {
    return !symbol.row->comment.empty() || symbol.is_by_operator();
  });
  if (!any) return {};
  RowWriter rows;
  for (const model::Symbol& symbol : plant.symbols) {
    rows.text("    {\"").literal(symbol.row->comment);
    rows.text(symbol.is_by_operator() ? "\", true},  // " : "\"},  // ").comment(symbol.name()).text("\n");
  }
  return rows.take();
}

std::string alarm_view_rows(const std::vector<model::Alarm>& alarms, const model::PlantModel& plant) {
  constexpr std::array<std::string_view, 3> kPriorities{"low", "medium", "high"};
  RowWriter rows;
  for (const model::Alarm& alarm : alarms) {
    const bool is_symbol = alarm.symbol != model::kNone;
    rows.text(is_symbol ? "    {.symbol = " : "    {.value = ").number(is_symbol ? alarm.symbol : alarm.value);
    rows.text(", .priority = symplant::tables::AlarmPriority::");
    rows.text(kPriorities[static_cast<std::size_t>(alarm.priority)]).text("},  // ");
    rows.comment(is_symbol ? std::string(plant.symbols[alarm.symbol].name()) : model::output_name(plant, alarm.value));
    rows.text("\n");
  }
  return rows.take();
}

std::string place_arrays(const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t c = 0; c < plant.links.size(); ++c) {
    const model::ControllerLink& link = plant.links[c];
    if (!link.rows.empty()) {
      rows.text(
          "// Symbols whose settings differ from those of their link: symbol, number, word order, value on loss.\n");
      rows.text("constexpr std::array<link::MapRow, ").number(link.rows.size());
      rows.text("> kLinkRows").number(c).text("{{\n");
      for (const link::MapRow& row : link.rows) {
        rows.text("    {").number(row.symbol).text(", ");
        if (row.number == link::MapRow::kDefault) {
          rows.text("link::MapRow::kDefault");
        } else {
          rows.number(row.number);
        }
        rows.text(", ").text(word_order(row.word_order)).text(", ").text(on_loss(row.on_loss));
        rows.text(row.excluded ? ", true" : row.node.empty() ? "" : ", false");
        if (!row.node.empty()) rows.text(", \"").literal(row.node).text("\"");
        rows.text("},  // ");
        rows.comment(plant.symbols[row.symbol].name()).text("\n");
      }
      rows.text("}};\n\n");
    }
    if (link.keep.empty()) continue;
    rows.text("constexpr std::array<std::string_view, ").number(link.keep.size()).text("> kKeep").number(c).text("{\n");
    for (const std::string_view peer : link.keep) rows.text("    \"").literal(peer).text("\",\n");
    rows.text("};\n\n");
  }
  const std::string arrays = rows.take_or("");
  return arrays.empty() ? arrays : "namespace links {\n\n" + arrays + "\n}  // namespace links\n";
}

std::string link_settings_rows(const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t c = 0; c < plant.links.size(); ++c) settings_row(rows, c, plant.links[c]);
  return rows.take();
}

}  // namespace symplant::emit
