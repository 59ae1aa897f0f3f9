// A comparison as one page for a browser: the built-in frame, style and script, and both traces as data.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/frame.hpp"
#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "view/json_writer.hpp"

namespace symplant::compare {

// The texts of generator/compare/page, embedded in the tool.
std::string_view chart_frame();
std::string_view chart_style();
std::string_view chart_script();

namespace {

using Kind = Difference::Kind;

constexpr std::size_t kMostChanges = 400'000;  ///< of elements without differences

class Page {
 public:
  Page(const Comparison& comparison, base::TextSink& sink)
      : of_(comparison), json_(sink, view::JsonWriter::Form::compact) {}

  void write() {
    choose();
    json_.begin_object();
    json_.member("summary", diag::visible(summary(of_)));
    trace("expected", *of_.expected);
    trace("actual", *of_.actual);
    json_.member("window", of_.window);
    json_.member("left_out", of_.compared.size() - chosen_.size());
    json_.key("series");
    json_.array(chosen_, [&](const Series* series) { write_series(*series); });
    json_.key("differences");
    json_.array(of_.differences, [&](const Difference& difference) { write_difference(difference); });
    json_.end_object();
    json_.finish();
  }

 private:
  /// Those with differences, most first; then others, while there is room.
  void choose() {
    for (const auto& [series, differences] : by_series(of_)) {
      if (series != nullptr) add(*series);
    }
    std::size_t changes = 0;
    for (const Series* const series : of_.compared) {
      if (numbers_.contains(series->key())) continue;
      changes += series->changes.size();
      if (changes <= kMostChanges) add(*series);
    }
  }

  void add(const Series& series) {
    numbers_.emplace(series.key(), chosen_.size());
    chosen_.push_back(&series);
  }

  void trace(std::string_view key, const Recording& recorded) {
    json_.key(key);
    json_.begin_object();
    json_.member("file", diag::visible(recorded.name));
    json_.member("end", recorded.end);
    json_.end_object();
  }

  void write_changes(std::string_view key, const Series* series) {
    json_.key(key);
    json_.begin_array();
    if (series != nullptr) {
      for (const Series::Change& change : series->changes) {
        json_.value(change.time);
        json_.value(std::isfinite(change.value) ? change.value : 0);
      }
    }
    json_.end_array();
  }

  void write_series(const Series& series) {
    const Series* const expected = of_.expected->find(series);
    const Series* const actual = of_.actual->find(series);
    double least = 0;
    double most = 0;
    for (const Series* const one : {expected, actual}) {
      if (one == nullptr) continue;
      for (const Series::Change& change : one->changes) {
        if (!std::isfinite(change.value)) continue;
        least = std::min(least, change.value);
        most = std::max(most, change.value);
      }
    }
    json_.begin_object();
    json_.member("name", diag::visible(name_of(series)));
    json_.member("kind", series.kind == Series::Kind::parts ? "parts" : "value");
    json_.member("least", least);
    json_.member("most", most);
    write_changes("expected", expected);
    write_changes("actual", actual);
    json_.end_object();
  }

  void write_difference(const Difference& difference) {
    const tables::Time begin = difference.time - (difference.kind == Kind::early ? difference.by : 0);
    json_.begin_object();
    json_.member("t", difference.time);
    json_.member("from", begin);
    json_.member("to", begin + difference.by);
    json_.member("of", difference.of == nullptr ? -1 : static_cast<int>(numbers_.at(difference.of->key())));
    json_.member("words", diag::visible(difference_words(difference)));
    json_.end_object();
  }

  const Comparison& of_;
  view::JsonWriter json_;
  std::vector<const Series*> chosen_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

}  // namespace

std::string chart_data(const Comparison& comparison) {
  return base::text_of([&](base::TextSink& json) { Page(comparison, json).write(); });
}

void write_chart_page(const std::string& title, const base::TextSource& data, base::TextSink& sink,
                      const std::string& section) {
  base::put_framed(chart_frame(),
                   {{"@title@", base::whole(diag::markup_text(title))},
                    {"@style@", [](base::TextSink& out) { out.put(chart_style()); }},
                    {"@section@", base::whole(section)},
                    {"@data@", data},
                    {"@script@", [](base::TextSink& out) { out.put(chart_script()); }}},
                   sink);
}

void write_html(const Comparison& comparison, base::TextSink& sink) { write_html(comparison, {}, sink); }

void write_html(const Comparison& comparison, const std::string& section, base::TextSink& sink) {
  write_chart_page(
      comparison.actual->name + " compared with " + comparison.expected->name,
      [&](base::TextSink& out) { out.put(diag::script_json(chart_data(comparison))); }, sink, section);
}

}  // namespace symplant::compare
