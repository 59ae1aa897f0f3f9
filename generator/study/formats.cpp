// The forms in which a study is shown.
#include "study/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/words.hpp"
#include "view/json_writer.hpp"

namespace symplant::study {
namespace {

constexpr std::size_t kMostRows = 40;
constexpr const char* kNoMovement =
    "no movement: after no change of an operation does a device arrive, or a number come to rest elsewhere";

/// Rounded down, so that only a perfect movement has 100 %.
std::string percent(double share) { return fmt::format("{:.1f} %", std::floor(share * 1000 + 1e-9) / 10); }

std::string start_words(const Study& study) {
  std::string text = fmt::format(
      "The run begins at {} as recorded: {} in other states than at the start of the model, {}",
      trace::seconds(study.begin), compare::counted(study.states, "device"), compare::counted(study.numbers, "value"));
  if (study.unknown != 0) {
    text += fmt::format("; {} begin{} in the state of the model, since no event shows another",
                        compare::counted(study.unknown, "device"), study.unknown == 1 ? "s" : "");
  }
  return text;
}

std::string title(const Study& study) {
  return fmt::format("accuracy of {}, times of the recording are exact to {}",
                     compare::counted(study.total.count, "movement"), trace::seconds(study.resolution));
}

/// The rows of a table for a terminal: of many the least accurate, those first.
std::vector<Row> shown_rows(const Study& study) {
  std::vector<Row> rows = study.rows;
  if (rows.size() <= kMostRows) return rows;
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.least < b.least; });
  rows.resize(kMostRows);
  return rows;
}

void write_row(view::JsonWriter& json, const Row& row) {
  json.begin_object();
  json.member("name", row.name);
  json.member("count", row.count);
  json.member("least", row.least);
  json.member("mean", row.mean);
  json.member("greatest", row.greatest);
  json.end_object();
}

std::string html_row(const Row& row, const char* cell) {
  return fmt::format("<tr><{0}>{1}</{0}><td>{2}</td><td>{3}</td><td>{4}</td><td>{5}</td></tr>\n", cell,
                     diag::markup_text(diag::visible(row.name)), row.count, percent(row.least), percent(row.mean),
                     percent(row.greatest));
}

}  // namespace

void write_text(const Study& study, const compare::Comparison& comparison, base::TextSink& sink) {
  const auto put = [&](const std::string& line) { sink.put(diag::visible(line) + "\n"); };
  put(start_words(study));
  compare::write_text(comparison, sink);
  if (study.rows.empty()) return put(kNoMovement);
  const std::vector<Row> rows = shown_rows(study);
  std::size_t width = study.total.name.size();
  for (const Row& row : rows) width = std::max(width, row.name.size());
  const auto put_row = [&](const Row& row) {
    put(fmt::format("  {:{}}  {:>4}  {:>8}  {:>8}  {:>8}", row.name, width, row.count, percent(row.least),
                    percent(row.mean), percent(row.greatest)));
  };
  put(title(study) + ":");
  put(fmt::format("  {:{}}  {:>4}  {:>8}  {:>8}  {:>8}", "movement", width, "n", "least", "mean", "greatest"));
  for (const Row& row : rows) put_row(row);
  if (rows.size() < study.rows.size()) {
    put(fmt::format("  ... and {} of {} or more; `--format json` has all",
                    compare::counted(study.rows.size() - rows.size(), "row"), percent(rows.back().least)));
  }
  put_row(study.total);
}

void write_json(const Study& study, const compare::Comparison& comparison, base::TextSink& sink) {
  compare::write_json(
      comparison,
      [&](view::JsonWriter& json) {
        json.key("accuracy");
        json.begin_object();
        json.member("begin", study.begin);
        json.member("resolution", study.resolution);
        json.key("movements");
        json.array(study.movements, [&](const Movement& movement) {
          json.begin_object();
          json.member("name", movement.name);
          json.member("begin", movement.begin);
          json.member("end", movement.end);
          json.member("accuracy", movement.accuracy);
          json.end_object();
        });
        json.key("rows");
        json.array(study.rows, [&](const Row& row) { write_row(json, row); });
        json.key("total");
        if (study.rows.empty()) {
          json.null();
        } else {
          write_row(json, study.total);
        }
        json.end_object();
      },
      sink);
}

void write_html(const Study& study, const compare::Comparison& comparison, base::TextSink& sink) {
  std::string section = "<section aria-labelledby=\"accuracy-title\">\n<h2 id=\"accuracy-title\">Accuracy</h2>\n<p>" +
                        diag::markup_text(diag::visible(start_words(study))) + "</p>\n";
  if (study.rows.empty()) {
    section += fmt::format("<p>{}</p>\n", diag::markup_text(kNoMovement));
  } else {
    section += fmt::format(
        "<p>{}</p>\n<table><thead><tr><th scope=\"col\">Movement</th><th scope=\"col\">n</th><th "
        "scope=\"col\">Least</th>"
        "<th scope=\"col\">Mean</th><th scope=\"col\">Greatest</th></tr></thead><tbody>\n",
        diag::markup_text(diag::visible(title(study))));
    for (const Row& row : study.rows) section += html_row(row, "td");
    section += html_row(study.total, "th") + "</tbody></table>\n";
  }
  compare::write_html(comparison, section + "</section>\n", sink);
}

}  // namespace symplant::study
