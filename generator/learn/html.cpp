// What was learned as one page for a browser: the built-in frame, style and script, and histograms as data.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/frame.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "learn/formats.hpp"
#include "learn/histogram.hpp"
#include "learn/pairs_formats.hpp"
#include "learn/words.hpp"
#include "symplant/trace/words.hpp"
#include "view/json_writer.hpp"

namespace symplant::learn {

// The texts of generator/learn/page, embedded in the tool, and the style of all charts.
std::string_view times_frame();
std::string_view chart_base_style();
std::string_view times_style();
std::string_view times_script();

namespace {

constexpr std::size_t kMostOutliers = 20;  ///< of one picture
constexpr std::size_t kMostNames = 1000;   ///< of a list of what was not seen

class TimesPage {
 public:
  TimesPage(const Learned& learned, base::TextSink& sink)
      : learned_(learned), plant_(*learned.plant), json_(sink, view::JsonWriter::Form::compact) {}

  void write() {
    json_.begin_object();
    text("summary", summary(learned_));
    json_.key("sources");
    json_.array(learned_.sources, [&](const Source& source) { json_.value(diag::visible(source_text(source))); });
    json_.key("times");
    json_.array(sorted_rows(), [&](const auto& row) { write_row(row.first, row.second); });
    json_.key("not_seen");
    write_not_seen();
    json_.key("pairs");
    json_.array(learned_.pairs.pairs, [&](const Pair& pair) { write_pair(pair); });
    json_.end_object();
    json_.finish();
  }

 private:
  void text(std::string_view key, std::string_view value) { json_.member(key, diag::visible(value)); }

  /// What is odd first; equally odd ones with more moves first.
  std::vector<std::pair<TimeRow, Oddities>> sorted_rows() const {
    std::vector<std::pair<TimeRow, Oddities>> rows;
    for (TimeRow& row : time_rows(learned_)) {
      const Oddities odd = oddities_of(row);
      rows.emplace_back(std::move(row), odd);
    }
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
      if (a.second.rank() != b.second.rank()) return a.second.rank() > b.second.rank();
      return a.first.time->samples.size() > b.first.time->samples.size();
    });
    return rows;
  }

  void write_row(const TimeRow& row, const Oddities& odd) {
    const LearnedTime& time = *row.time;
    const Statistics& of = time.statistics;
    json_.begin_object();
    text("title", group_title(*row.group));
    text("of", row.of.empty() ? std::string(row.kind) : row.of + " " + std::string(row.kind));
    text("learned", duration_words(time.proposed));
    text("model", duration_words(row.model));
    text("from", provenance(learned_, *row.group, time));
    text("odd", odd.text(row));
    text("groups", groups_text(learned_, time));
    text("figures", "min " + trace::seconds(of.min) + ", median " + trace::seconds(of.median) + ", p95 " +
                        trace::seconds(of.p95) + ", max " + trace::seconds(of.max));
    write_span("proposed", time.proposed);
    write_span("given", row.model);
    write_histogram(histogram_of(time, row.model));
    write_outliers(row);
    json_.end_object();
  }

  /// A time as the least and the largest one.
  void write_span(std::string_view key, const description::Duration& duration) {
    using Kind = description::Duration::Kind;
    json_.key(key);
    if (duration.kind == Kind::seconds) return json_.null();
    const Time spread = duration.kind == Kind::normal ? 3 * duration.b : 0;
    json_.row(std::max<Time>(0, duration.a - spread),
              duration.kind == Kind::uniform ? duration.b : duration.a + spread);
  }

  void write_histogram(const Histogram& histogram) {
    json_.key("histogram");
    json_.begin_object();
    json_.member("from", histogram.from);
    json_.member("step", histogram.step);
    json_.key("counts");
    json_.array(histogram.counts, [&](std::uint32_t count) { json_.value(count); });
    json_.key("outliers");
    json_.array(histogram.outliers, [&](std::uint32_t count) { json_.value(count); });
    json_.end_object();
  }

  void write_outliers(const TimeRow& row) {
    const std::vector<std::size_t>& outliers = row.time->clusters.outliers;
    json_.key("outliers");
    json_.begin_array();
    for (std::size_t i = 0; i < std::min(outliers.size(), kMostOutliers); ++i) {
      json_.value(diag::visible(outlier_text(learned_, *row.group, row.time->samples[outliers[i]])));
    }
    if (outliers.size() > kMostOutliers) {
      json_.value("and " + std::to_string(outliers.size() - kMostOutliers) + " more");
    }
    json_.end_array();
  }

  /// A list with its title; `name` makes a text of an item.
  template <class Item, class Name>
  void write_list(std::string_view title, const std::vector<Item>& items, Name name) {
    if (items.empty()) return;
    json_.begin_object();
    json_.member("title", title);
    json_.member("count", items.size());
    json_.key("names");
    json_.begin_array();
    for (std::size_t i = 0; i < std::min(items.size(), kMostNames); ++i) {
      json_.value(diag::visible(std::string(name(items[i]))));
    }
    json_.end_array();
    json_.end_object();
  }

  void write_not_seen() {
    const NotSeen& not_seen = learned_.not_seen;
    const auto unit = [&](std::uint32_t index) { return plant_.units[index].path; };
    const auto symbol = [&](std::uint32_t index) { return plant_.symbols[index].name(); };
    json_.begin_array();
    write_list("Devices that never moved", not_seen.devices, unit);
    write_list("Transitions never taken", not_seen.transitions, [&](const auto& of) {
      return std::string(unit(of.first)) + " " + transition_name(plant_, of.first, of.second);
    });
    write_list("Events that never changed", not_seen.events, symbol);
    write_list("Symbols in no recording", not_seen.symbols, symbol);
    write_list("Names in recordings that are no symbol", not_seen.names, [](const UnknownName& unknown) {
      return unknown.nearest.empty() ? unknown.name : unknown.name + " (similar: " + unknown.nearest + ")";
    });
    json_.end_array();
  }

  void write_pair(const Pair& pair) {
    json_.begin_object();
    text("operation", plant_.symbols[pair.operation].name());
    text("event", (pair.inverted ? "not " : "") + std::string(plant_.symbols[pair.event].name()));
    text("evidence", evidence(pair));
    json_.end_object();
  }

  const Learned& learned_;
  const model::PlantModel& plant_;
  view::JsonWriter json_;
};

}  // namespace

void write_html(const Learned& learned, base::TextSink& sink) {
  const base::TextSource data = [&](base::TextSink& out) {
    const std::string json = base::text_of([&](base::TextSink& whole) { TimesPage(learned, whole).write(); });
    out.put(diag::script_json(json));
  };
  base::put_framed(times_frame(),
                   {{"@title@", base::whole(diag::markup_text("Times of " + learned.plant->name))},
                    {"@style@",
                     [](base::TextSink& out) {
                       out.put(chart_base_style());
                       out.put(times_style());
                     }},
                    {"@data@", data},
                    {"@script@", [](base::TextSink& out) { out.put(times_script()); }}},
                   sink);
}

}  // namespace symplant::learn
