// Findings as JSON for programs.
#include "diag/json.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace symplant::diag {

namespace {

using Json = nlohmann::ordered_json;

void add_place(Json& object, const Place& place) {
  if (!place.source) return;
  object["file"] = place.source->path();
  if (place.source->text().empty()) return;
  const base::Position begin = place.source->position(place.span.begin);
  const base::Position end = place.source->position(place.span.end);
  object["line"] = begin.line;
  object["column"] = begin.column;
  object["end_line"] = end.line;
  object["end_column"] = end.column;
  object["span"] = {place.span.begin, place.span.end};
}

Json finding_of(const Diagnostic& finding) {
  Json object;
  object["rule"] = finding.rule->id;
  object["slug"] = finding.rule->slug;
  object["severity"] = severity_name(finding.severity);
  object["message"] = finding.message;
  add_place(object, finding.place);
  object["related"] = Json::array();
  for (const Related& related : finding.related) {
    Json other;
    other["message"] = related.message;
    add_place(other, related.place);
    object["related"].push_back(std::move(other));
  }
  return object;
}

}  // namespace

std::string render_json(std::span<const Diagnostic> findings, const LeftOut& left_out) {
  Json document;
  document["symplant-diagnostics"] = kJsonVersion;
  document["findings"] = Json::array();
  std::array<std::size_t, 3> counts{};
  for (const Diagnostic& finding : findings) {
    document["findings"].push_back(finding_of(finding));
    ++counts[static_cast<std::size_t>(finding.severity)];
  }
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    document["counts"][std::string(severity_name(severity))] = counts[static_cast<std::size_t>(severity)];
  }
  if (left_out.by_description != 0) document["counts"]["ignored"] = left_out.by_description;
  if (left_out.by_options != 0) document["counts"]["left_out"] = left_out.by_options;
  // A path or a message may hold bytes that are no UTF-8; they must not make the whole report fail.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace symplant::diag
