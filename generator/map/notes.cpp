// The lines below the table of `symplant map`.
#include "map/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "diag/visible_text.hpp"
#include "map/channels.hpp"
#include "map/texts.hpp"
#include "symplant/link/status_fields.hpp"
#include "view/words.hpp"

namespace symplant::map {
namespace {

std::string time_text(tables::Time time) { return view::duration_text(description::Duration::fixed(time)); }

void add_sizes(std::string& text, const link::modbus::IoMap& map) {
  for (std::size_t t = 0; t < link::modbus::kTables; ++t) {
    if (map.sizes[t] == 0) continue;
    fmt::format_to(std::back_inserter(text), "{}s: size {}{}\n",
                   link::modbus::table_name(static_cast<link::modbus::Table>(t)), map.sizes[t],
                   map.packed[t] ? ", packed in list order, since an address has no number below 65536" : "");
  }
  const auto count = [&](const std::vector<std::uint32_t>& symbols, std::string_view why) {
    if (!symbols.empty()) fmt::format_to(std::back_inserter(text), "on no link: {} {}\n", symbols.size(), why);
  };
  count(map.excluded, "excluded by plant.json");
  count(map.without_address, "without a usable address");
  count(map.of_8_bits, "of 8 bits, for which plant.json gives no register");
  count(map.too_many, "beyond the 65536 addresses of a table");
}

void add_status_block(std::string& text, const link::modbus::IoMap& map) {
  if (!map.status_block) {
    text +=
        map.no_room_for_status ? "status block: off, there is no room for it above the map\n" : "status block: off\n";
    return;
  }
  const std::uint32_t first = *map.status_block;
  fmt::format_to(std::back_inserter(text), "status block: input registers {}\n", range_text(first, link::kStatusWords));
  for (const link::StatusField& field : link::kStatusFields) {
    fmt::format_to(std::back_inserter(text), "  {}  {}: {}\n", range_text(first + field.first, field.words), field.name,
                   field.meaning);
  }
}

void add_policies(std::string& text, const LinkView& view) {
  const link::modbus::IoMap& map = view.served();
  const link::LinkSettings& settings = view.choice.settings;
  if (map.watchdog) {
    fmt::format_to(std::back_inserter(text), "watchdog: holding register {}\n", *map.watchdog);
  }
  const std::string silence = map.watchdog ? time_text(settings.watchdog_within) + " without a change of the watchdog"
                                           : time_text(settings.loss_after) + " without a request";
  fmt::format_to(std::back_inserter(text), "lost after {}: operations {}, the plant {}\n", silence,
                 link::loss_words(view.of->tables, view.map),
                 settings.plant_on_loss == link::PlantOnLoss::freeze ? "freezes" : "runs on");
  fmt::format_to(std::back_inserter(text),
                 "after a loss: writes are collected for at most {} before they take effect\n",
                 time_text(settings.resync));
}

void add_channels(std::string& text, const link::modbus::IoMap& map) {
  const std::vector<Channel> channels = channels_of(map);
  if (!channels.empty()) text += "channels for an I/O scanner, numbers counted from 0:\n";
  for (const Channel& channel : channels) {
    fmt::format_to(std::back_inserter(text), "  {:<30}  function {:<2}  start {:<5}  count {}{}\n", channel.access(),
                   channel.function(), channel.first, channel.count,
                   channel.part == Channel::Part::symbols ? "" : fmt::format("  {}", channel.part_name()));
  }
}

void add_client(std::string& text, const LinkView& view) {
  for (const std::string& note : view.map.notes) text += note + "\n";
  for (const link::Unreachable& one : view.map.left_out) {
    text += fmt::format("not linked: {} {}\n", diag::visible(view.of->plant.symbols[one.symbol].name()),
                        diag::visible(one.reason));
  }
}

}  // namespace

std::string map_notes(const LinkView& view) {
  std::string text;
  if (!view.is_server()) {
    add_client(text, view);
    return text;
  }
  add_sizes(text, view.served());
  fmt::format_to(std::back_inserter(text), "word order: {}\n", word_order_text(view.choice.settings.word_order));
  add_status_block(text, view.served());
  add_channels(text, view.served());
  add_policies(text, view);
  fmt::format_to(std::back_inserter(text), "map hash: {:016x}\n",
                 link::modbus::map_hash(view.of->tables, view.served()));
  return text;
}

}  // namespace symplant::map
