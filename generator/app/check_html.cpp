// The result of a check as one HTML page.
#include "app/check_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/score_text.hpp"
#include "diag/encode.hpp"
#include "score/levels.hpp"
#include "score/shapes.hpp"

namespace symplant::app {
namespace {

constexpr std::size_t kMostRepairs = 10;
constexpr std::size_t kMostCells = 400;
constexpr std::size_t kMostFindings = 200;  ///< of a rule
constexpr std::size_t kMostRows = 50;       ///< of a finding
constexpr int kShades = 5;

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>symplant check</title>
<style>
:root { color-scheme: light dark; --text: #1b1f24; --soft: #57606a; --back: #fff; --line: #d0d7de; }
@media (prefers-color-scheme: dark) { :root { --text: #e6edf3; --soft: #9aa4af; --back: #0d1117; --line: #30363d; } }
body { font: 15px/1.45 system-ui, sans-serif; color: var(--text); background: var(--back); max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; overflow-wrap: anywhere; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.big { font-size: 2.6rem; font-weight: 600; line-height: 1.1; } .soft { color: var(--soft); }
.scores { display: flex; flex-wrap: wrap; gap: 2.5rem; }
.stations { display: grid; grid-template-columns: repeat(auto-fill, minmax(8.5rem, 1fr)); gap: 4px; }
.stations div { padding: .45rem .6rem; border-radius: 4px; overflow-wrap: anywhere; } .stations b { float: right; padding-left: .5rem; }
.s0 { background: #08306b; color: #fff; } .s1 { background: #2171b5; color: #fff; } .s2 { background: #9ecae1; color: #000; }
.s3 { background: #c6dbef; color: #000; } .s4 { background: #edf4fb; color: #000; }
table { border-collapse: collapse; width: 100%; } td, th { text-align: left; vertical-align: top; padding: .3rem .6rem .3rem 0; border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
tr > :first-child { text-align: right; white-space: nowrap; width: 1%; } details { border-bottom: 1px solid var(--line); padding: .35rem 0; }
summary { cursor: pointer; } li { overflow-wrap: anywhere; } code { font-size: .9em; }
@media print { body { margin: 0; max-width: none; } .stations div { print-color-adjust: exact; -webkit-print-color-adjust: exact; } h2, tr, summary { break-after: avoid; } }
</style>
)";

std::string plural(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// A message with its back-ticks as `<code>`.
std::string message_html(std::string_view message) {
  std::string html;
  bool code = false;
  for (const char c : diag::markup_text(message)) {
    if (c != '`') {
      html += c;
      continue;
    }
    html += code ? "</code>" : "<code>";
    code = !code;
  }
  return html + (code ? "</code>" : "");
}

std::string line_of(const diag::Location& location) {
  if (!location.source || location.source->text().empty()) return "";
  return fmt::format(" <span class=soft>line {}</span>", location.source->position(location.span.begin).line);
}

/// Darker where less is accounted for.
int shade(const score::Counts& counts) {
  const std::size_t share = percent_of(counts.accounted(), counts.counted());
  return std::min(kShades - 1, static_cast<int>(share * kShades / 100));
}

std::string stations_html(const model::PlantModel& plant, const score::PlantScore& score) {
  const std::vector<score::Part> stations = score::parts_of(plant, score, score::Level::station);
  if (stations.size() < 2) return "";
  std::string html =
      "<h2>Stations</h2>\n<p class=soft>The share of inputs and outputs that is accounted for; darker is less.</p>\n"
      "<div class=stations>\n";
  const std::size_t shown = std::min(stations.size(), kMostCells);
  for (std::size_t i = 0; i < shown; ++i) {
    const score::Counts& counts = stations[i].counts;
    if (counts.counted() == 0) continue;
    const std::string name = stations[i].path();
    html += fmt::format("<div class=s{} title=\"{} of {} symbols left over\">{}<b>{}&nbsp;%</b></div>\n", shade(counts),
                        counts.left_over(), counts.counted(), name.empty() ? "(none)" : diag::markup_text(name),
                        percent_of(counts.accounted(), counts.counted()));
  }
  html += "</div>\n";
  if (shown < stations.size()) html += fmt::format("<p class=soft>and {} more</p>\n", stations.size() - shown);
  return html;
}

struct Repair {
  std::size_t symbols;
  std::string html;
};

std::string repairs_html(const model::PlantModel& plant, const score::PlantScore& score,
                         const diag::Diagnostics& findings) {
  std::vector<Repair> repairs;
  for (const diag::Diagnostic& finding : findings.all()) {
    if (finding.severity == diag::Severity::note) continue;
    repairs.push_back({finding.count + finding.shown_consequences, message_html(finding.message)});
  }
  if (plant.levels() == nullptr) {  // where names have levels, each of these symbols has a finding
    for (const score::Shape& shape : score::left_over_shapes(plant, score)) {
      repairs.push_back(
          {shape.count, fmt::format("Symbols like <code>{}</code> {}: extend the naming rule",
                                    diag::markup_text(shape.text), message_html(reason_text(shape.account)))});
    }
  }
  if (repairs.empty()) return "";
  std::stable_sort(repairs.begin(), repairs.end(),
                   [](const Repair& a, const Repair& b) { return a.symbols > b.symbols; });
  std::string html = "<h2>Most worth repairing</h2>\n<table>\n<tr><th>symbols<th>what\n";
  for (std::size_t i = 0; i < std::min(repairs.size(), kMostRepairs); ++i) {
    html += fmt::format("<tr><td>{}<td>{}\n", repairs[i].symbols, repairs[i].html);
  }
  return html + "</table>\n";
}

std::string finding_html(const diag::Diagnostic& finding) {
  std::string html = fmt::format("<li>{}{}", message_html(finding.message), line_of(finding.location));
  const std::size_t shown = std::min(finding.related.size(), kMostRows);
  if (shown != 0) html += "\n<ul>\n";
  for (std::size_t i = 0; i < shown; ++i) {
    html += fmt::format("<li>{}{}\n", message_html(finding.related[i].message), line_of(finding.related[i].location));
  }
  if (shown < finding.related.size()) html += fmt::format("<li>and {} more\n", finding.related.size() - shown);
  return html + (shown == 0 ? "\n" : "</ul>\n");
}

std::string findings_html(const diag::Diagnostics& findings) {
  if (findings.all().empty()) return "<h2>Findings</h2>\n<p>None.</p>\n";
  std::map<std::pair<int, std::string_view>, std::vector<const diag::Diagnostic*>> by_rule;
  for (const diag::Diagnostic& finding : findings.all()) {
    by_rule[{-static_cast<int>(finding.severity), finding.rule->id}].push_back(&finding);
  }
  std::string html = "<h2>Findings</h2>\n";
  for (const auto& [key, all] : by_rule) {
    const diag::Diagnostic& first = *all.front();
    std::size_t symbols = 0;
    for (const diag::Diagnostic* finding : all) symbols += finding->count;
    html += fmt::format("<details>\n<summary><b>{}</b> {} {}: {} ({})</summary>\n<ul>\n",
                        diag::severity_name(first.severity), first.rule->id, first.rule->slug,
                        diag::markup_text(first.rule->summary), plural(symbols, "symbol"));
    for (std::size_t i = 0; i < std::min(all.size(), kMostFindings); ++i) html += finding_html(*all[i]);
    if (all.size() > kMostFindings) html += fmt::format("<li>and {} more\n", all.size() - kMostFindings);
    html += "</ul>\n</details>\n";
  }
  return html;
}

}  // namespace

void CheckPage::add(const std::string& file, const model::PlantModel& plant, const score::PlantScore& score,
                    const diag::Diagnostics& findings) {
  const score::Counts& total = score.total;
  body_ += fmt::format("<h1>{}</h1>\n", diag::markup_text(file));
  for (const model::PlantList& list : plant.lists) {
    body_ += fmt::format("<p class=soft>{}: {}, {}</p>\n", diag::markup_text(list.name()),
                         diag::markup_text(list.table->title), plural(list.table->rows.size(), "row"));
  }
  body_ += fmt::format(
      "<div class=scores>\n<div><div class=big>{} %</div>of {} accounted for</div>\n"
      "<div><div class=big>{} %</div>move a device or report that it moved</div>\n"
      "<div><div class=big>{}</div>{}</div>\n</div>\n<p>{}.</p>\n",
      percent_of(total.accounted(), total.counted()),
      total.counted() == 1 ? std::string("1 input or output") : fmt::format("{} inputs and outputs", total.counted()),
      percent_of(total.paired(), total.counted()), plant.units.size(), plant.units.size() == 1 ? "device" : "devices",
      diag::markup_text(score_text(total)));
  body_ += stations_html(plant, score) + repairs_html(plant, score, findings) + findings_html(findings);
}

void CheckPage::add(const std::string& file, const diag::Diagnostics& findings) {
  body_ +=
      fmt::format("<h1>{}</h1>\n<p>The plant cannot be read.</p>\n", diag::markup_text(file)) + findings_html(findings);
}

std::string CheckPage::take() const { return fmt::format("{}<body>\n{}</body>\n</html>\n", kHead, body_); }

}  // namespace symplant::app
