// What was learned, for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "diag/visible_text.hpp"
#include "learn/formats.hpp"
#include "learn/groups.hpp"
#include "learn/pairs_formats.hpp"
#include "learn/words.hpp"
#include "symplant/trace/words.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::learn {
namespace {

constexpr std::size_t kMostListed = 20;  ///< outliers, names
constexpr std::size_t kMostRows = 20;    ///< of one table
constexpr std::size_t kColumns = 11;

using Cells = std::array<std::string, kColumns>;

/// The width of a text in columns of a terminal.
std::size_t terminal_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    width += static_cast<std::size_t>(diag::display_width(point.value));
    at += point.length;
  }
  return width;
}

/// Rows in columns of equal width.
std::string table(const std::vector<Cells>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const Cells& row : rows) {
    for (std::size_t c = 0; c < kColumns; ++c) widths[c] = std::max(widths[c], terminal_width(row[c]));
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < kColumns; ++c) {
      line += "  " + row[c] + std::string(widths[c] - terminal_width(row[c]), ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Cells cells_of(const TimeRow& row) {
  const Statistics& of = row.time->statistics;
  return {group_title(*row.group),   row.of,
          std::string(row.kind),     duration_words(row.time->proposed),
          duration_words(row.model), std::to_string(of.count),
          trace::seconds(of.min),    trace::seconds(of.median),
          trace::seconds(of.p95),    trace::seconds(of.max),
          oddities_of(row).text(row)};
}

class TextWriter {
 public:
  TextWriter(const Learned& learned, base::TextSink& sink, bool all)
      : learned_(learned), plant_(*learned.plant), rows_(time_rows(learned)), all_(all), out_(sink) {}

  void write() {
    for (const Source& source : learned_.sources) put(source_text(source));
    put(summary(learned_));
    if (all_) {
      for (const UnusedMoves& moves : learned_.unused_moves) put("  not used: " + unused_text(learned_, moves));
    }
    write_tables();
    write_groups();
    write_outliers();
    write_not_seen();
    write_pairs();
    out_.finish();
  }

 private:
  std::size_t most_rows() const { return all_ ? SIZE_MAX : kMostRows; }
  std::size_t most_listed() const { return all_ ? SIZE_MAX : kMostListed; }

  void put(const std::string& line) { out_.add(diag::visible(line) + "\n"); }

  /// A table for each kind of device, in the order of their first device.
  void write_tables() {
    std::vector<std::string> kinds;
    std::unordered_map<std::string, std::vector<const TimeRow*>> rows;
    for (const TimeRow& row : rows_) {
      const std::string kind = text::to_upper(kind_of(plant_.units[row.group->times.unit]));
      std::vector<const TimeRow*>& of_kind = rows[kind];
      if (of_kind.empty()) kinds.push_back(kind);
      of_kind.push_back(&row);
    }
    for (const std::string& kind : kinds) write_table(kind, rows[kind]);
  }

  /// Of too many rows those that are odd.
  void write_table(const std::string& kind, std::vector<const TimeRow*>& rows) {
    std::set<std::uint32_t> devices;
    for (const TimeRow* row : rows) devices.insert(row->group->units.begin(), row->group->units.end());
    if (rows.size() > most_rows()) {
      std::stable_sort(rows.begin(), rows.end(), [](const TimeRow* a, const TimeRow* b) {
        return oddities_of(*a).rank() > oddities_of(*b).rank();
      });
    }
    out_.add("\n");
    put(fmt::format("{}: {} {}", kind, devices.size(), devices.size() == 1 ? "device" : "devices"));
    std::vector<Cells> lines{
        {"device", "transition", "time", "learned", "model", "moves", "min", "median", "p95", "max", ""}};
    for (std::size_t i = 0; i < std::min(rows.size(), most_rows()); ++i) {
      lines.push_back(cells_of(*rows[i]));
      for (std::string& cell : lines.back()) cell = diag::visible(cell);
    }
    out_.add(table(lines));
    if (rows.size() > most_rows()) put(fmt::format("  and {} more", rows.size() - most_rows()));
  }

  std::string name_of(const TimeRow& row) const {
    std::string name = row.group->name;
    if (!row.of.empty()) name += " " + row.of;
    return name + " " + std::string(row.kind);
  }

  void write_groups() {
    bool first = true;
    for (const TimeRow& row : rows_) {
      const std::string text = groups_text(learned_, *row.time);
      if (text.empty()) continue;
      if (std::exchange(first, false)) out_.add("\nMoves of more than one kind:\n");
      put(fmt::format("  {}: {}", name_of(row), text));
    }
  }

  void write_outliers() {
    std::size_t count = 0;
    for (const TimeRow& row : rows_) {
      for (const std::size_t i : row.time->clusters.outliers) {
        if (count++ == 0) out_.add("\nOutliers, not used:\n");
        if (count > most_listed()) continue;
        put(fmt::format("  {}: {}", name_of(row), outlier_text(learned_, *row.group, row.time->samples[i])));
      }
    }
    if (count > most_listed()) put(fmt::format("  and {} more", count - most_listed()));
  }

  /// `names` makes the name of an index.
  template <class Item, class Name>
  void write_list(const std::string& title, const std::vector<Item>& items, Name name) {
    if (items.empty()) return;
    std::string text;
    for (std::size_t i = 0; i < std::min(items.size(), most_listed()); ++i) {
      text += (i == 0 ? "" : ", ") + std::string(name(items[i]));
    }
    if (items.size() > most_listed()) text += fmt::format(" and {} more", items.size() - most_listed());
    put(fmt::format("{} ({}): {}", title, items.size(), text));
  }

  void write_not_seen() {
    const NotSeen& not_seen = learned_.not_seen;
    out_.add("\n");
    write_list("devices that never moved", not_seen.devices,
               [&](std::uint32_t unit) { return plant_.units[unit].path; });
    write_list("transitions never taken", not_seen.transitions, [&](const auto& of) {
      return std::string(plant_.units[of.first].path) + " " + transition_name(plant_, of.first, of.second);
    });
    const auto symbol = [&](std::uint32_t s) { return plant_.symbols[s].name(); };
    write_list("events that never changed", not_seen.events, symbol);
    write_list("symbols in no recording", not_seen.symbols, symbol);
    write_list("names in recordings that are no symbol", not_seen.names, [](const UnknownName& unknown) {
      return unknown.nearest.empty() ? unknown.name : unknown.name + " (similar: " + unknown.nearest + ")";
    });
  }

  /// Nothing if names pair all symbols that changed.
  void write_pairs() {
    if (learned_.pairs.operations == 0 || learned_.pairs.events == 0) return;
    out_.add("\n" + pairs_text(learned_.pairs, plant_));
  }

  const Learned& learned_;
  const model::PlantModel& plant_;
  const std::vector<TimeRow> rows_;
  const bool all_;
  base::PartCollector out_;
};

}  // namespace

void write_text(const Learned& learned, base::TextSink& sink) { TextWriter(learned, sink, false).write(); }

void write_long_text(const Learned& learned, base::TextSink& sink) { TextWriter(learned, sink, true).write(); }

}  // namespace symplant::learn
