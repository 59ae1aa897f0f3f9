// Findings as JSON for programs.
#include "diag/json.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace symplant::diag {

namespace {

using Json = nlohmann::ordered_json;

void add_location(Json& object, const Location& location) {
  if (!location.source) return;
  object["file"] = location.source->path();
  if (location.source->text().empty()) return;
  const text::Position begin = location.source->position(location.span.begin);
  const text::Position end = location.source->position(location.span.end);
  object["line"] = begin.line;
  object["column"] = begin.column;
  object["end_line"] = end.line;
  object["end_column"] = end.column;
  object["span"] = {location.span.begin, location.span.end};
}

Json finding_of(const Diagnostic& finding) {
  Json object;
  object["rule"] = finding.rule->id;
  object["slug"] = finding.rule->slug;
  object["severity"] = severity_name(finding.severity);
  object["message"] = finding.message;
  add_location(object, finding.location);
  object["related"] = Json::array();
  for (const Related& related : finding.related) {
    Json other;
    other["message"] = related.message;
    add_location(other, related.location);
    object["related"].push_back(std::move(other));
  }
  return object;
}

/// Appends the object with its lines indented by `depth` characters.
void append(std::string& text, const Json& object, std::size_t depth) {
  // A path or a message may hold bytes that are not UTF-8; they must not make the whole report fail.
  const std::string lines = object.dump(2, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size() - 1) + 1;
    if (at != 0) text.append(depth, ' ');
    text.append(lines, at, end - at);
    at = end;
  }
}

}  // namespace

std::string render_json(std::span<const Diagnostic> findings, const LeftOut& left_out) {
  return render_json(std::span(&findings, 1), left_out);
}

std::string render_json(std::span<const std::span<const Diagnostic>> parts, const LeftOut& left_out,
                        std::span<const std::string> plants) {
  // One finding at a time: a document of a million findings would fill the memory.
  std::string text = "{\n  \"symplant-diagnostics\": " + std::to_string(kJsonVersion) + ",\n  \"findings\": [";
  std::array<std::size_t, 3> counts{};
  bool any = false;
  for (const std::span<const Diagnostic> findings : parts) {
    for (const Diagnostic& finding : findings) {
      text += any ? ",\n    " : "\n    ";
      append(text, finding_of(finding), 4);
      ++counts[static_cast<std::size_t>(finding.severity)];
      any = true;
    }
  }
  text += any ? "\n  ],\n  \"counts\": " : "],\n  \"counts\": ";
  Json counted;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    counted[std::string(severity_name(severity))] = counts[static_cast<std::size_t>(severity)];
  }
  if (left_out.by_description != 0) counted["ignored"] = left_out.by_description;
  if (left_out.by_options != 0) counted["left_out"] = left_out.by_options;
  append(text, counted, 2);
  for (std::size_t i = 0; i < plants.size(); ++i) {
    text.append(i == 0 ? ",\n  \"plants\": [\n    " : ",\n    ").append(plants[i]);
  }
  return text += plants.empty() ? "\n}\n" : "\n  ]\n}\n";
}

}  // namespace symplant::diag
