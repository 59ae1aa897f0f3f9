// Findings that a plant has had before.
#include "findings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "check/catalogue.hpp"
#include "findings/selection.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"

namespace symplant::findings {
namespace {

constexpr std::string_view kSchema = R"({
  "title": "a baseline, an object with `symplant-baseline` and `findings`",
  "type": "object", "required": ["symplant-baseline", "findings"], "additionalProperties": false,
  "properties": {
    "symplant-baseline": { "title": "the version 1", "const": 1 },
    "findings": { "title": "an array", "type": "array", "items": {
      "title": "an object with `plant`, `rule`, `of` and `count`", "type": "object",
      "required": ["plant", "rule", "of", "count"], "additionalProperties": false,
      "properties": {
        "plant": { "title": "the plant's file", "type": "string" },
        "rule": { "title": "the id of a rule, such as `SP401`", "type": "string" },
        "of": { "title": "a name or shape", "type": "string" },
        "count": { "title": "a number above 0", "type": "integer", "minimum": 1, "maximum": 1000000000 } } } } } })";

/// What identifies a finding beyond its rule: the shape or the name of what it is about, or else its words.
const std::string& identity(const diag::Diagnostic& finding) {
  const diag::Subjects& subjects = finding.subjects;
  if (!subjects.shape.empty()) return subjects.shape;
  return subjects.about.empty() ? finding.message : subjects.about.front().name;
}

}  // namespace

base::Result<Baseline, diag::Diagnostics> Baseline::read(std::shared_ptr<const text::SourceFile> file) {
  diag::Diagnostics faults;
  const json::Document document = json::parse(file->text());
  std::vector<json::Placed> placed = document.faults;
  if (document.root != nullptr) placed = json::locate(file->text(), json::Schema(kSchema).check(*document.root));
  for (const json::Placed& fault : placed) {
    faults.add(*check::find_rule("SP627"), fault.message, {file, {fault.span.begin, fault.span.end}});
  }
  if (!placed.empty()) return faults;
  Baseline baseline;
  for (const nlohmann::json& entry : document.root->at("findings")) {
    const auto text_of = [&](const char* key) { return entry.at(key).get<std::string>(); };
    const diag::RuleInfo* rule = check::find_rule(text_of("rule"));  // it may have another id now
    const std::string id = rule == nullptr ? text_of("rule") : std::string(rule->id);
    baseline.counts_[{text_of("plant"), id, text_of("of")}].given += entry.at("count").get<std::size_t>();
  }
  baseline.file_ = std::move(file);
  return baseline;
}

diag::Diagnostics Baseline::apply(const std::string& plant, diag::Diagnostics findings) {
  const auto count_of = [&](const diag::Diagnostic& finding) -> Count& {
    return counts_[{plant, std::string(finding.rule->id), identity(finding)}];
  };
  for (const diag::Diagnostic& finding : findings.all()) {
    if (!is_binding(*finding.rule)) ++count_of(finding).found;
  }
  for (diag::Diagnostic& finding : findings.take()) {
    const Count& count = count_of(finding);
    if (!is_binding(*finding.rule) && kept(count) == count.found) {
      findings.leave_out({0, 0, 0, 1});
    } else {
      findings.add(std::move(finding));
    }
  }
  return findings;
}

void Baseline::report_stale(diag::Diagnostics& findings) const {
  std::size_t stale = 0;
  std::string first;
  for (const auto& [key, count] : counts_) {
    if (count.found >= count.given) continue;
    stale += count.given - count.found;
    const auto& [plant, rule, of] = key;
    if (first.empty()) first = fmt::format("{} of `{}` in {}", rule, of, plant);
  }
  if (stale == 0) return;
  findings.add(*check::find_rule("SP626"),
               fmt::format("{} finding{} of the baseline {} no longer there, such as {}: run the same command with "
                           "`--write-baseline` to remove them",
                           stale, stale == 1 ? "" : "s", stale == 1 ? "is" : "are", first),
               {file_, {0, 0}});
}

std::string Baseline::text() const {
  std::string lines;
  for (const auto& [key, count] : counts_) {
    const auto& [plant, rule, of] = key;
    if (kept(count) == 0) continue;
    const nlohmann::ordered_json entry{{"plant", plant}, {"rule", rule}, {"of", of}, {"count", kept(count)}};
    lines += (lines.empty() ? "\n    " : ",\n    ") +
             entry.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  return "{\n  \"symplant-baseline\": 1,\n  \"findings\": [" + lines + (lines.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::size_t Baseline::size() const {
  std::size_t size = 0;
  for (const auto& [key, count] : counts_) size += kept(count);
  return size;
}

}  // namespace symplant::findings
