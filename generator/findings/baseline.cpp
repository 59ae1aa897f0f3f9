// Findings that a plant has had before.
#include "findings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "check/rules.hpp"
#include "findings/settings.hpp"
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
  if (document.root != nullptr) {
    for (json::Placed& fault : json::locate(file->text(), json::Schema(kSchema).check(*document.root))) {
      placed.push_back(std::move(fault));
    }
  }
  for (const json::Placed& fault : placed) {
    faults.add(check::kBaselineNotValid.info, fault.message, {file, {fault.span.begin, fault.span.end}});
  }
  if (!placed.empty()) return faults;
  Baseline baseline;
  for (const nlohmann::json& entry : document.root->at("findings")) {
    const auto text_of = [&](const char* key) { return entry.at(key).get<std::string>(); };
    baseline.counts_[{text_of("plant"), text_of("rule"), text_of("of")}].given += entry.at("count").get<std::size_t>();
  }
  baseline.file_ = std::move(file);
  return baseline;
}

diag::Diagnostics Baseline::apply(const std::string& plant, const diag::Diagnostics& findings) {
  const auto key_of = [&](const diag::Diagnostic& finding) { return Key(plant, finding.rule->id, identity(finding)); };
  for (const diag::Diagnostic& finding : findings.all()) {
    if (!is_binding(*finding.rule)) ++counts_[key_of(finding)].found;
  }
  diag::Diagnostics reported;
  diag::LeftOutByOption left_out = findings.left_out();
  for (const diag::Diagnostic& finding : findings.all()) {
    const auto known = counts_.find(key_of(finding));
    const bool has_it = known != counts_.end() && (file_ == nullptr || known->second.found <= known->second.given);
    if (has_it) {
      ++left_out.baseline;
    } else {
      reported.add(finding);
    }
  }
  for (const diag::Ignored& ignored : findings.ignored()) reported.ignore(ignored.finding, ignored.why);
  reported.leave_out(left_out);
  return reported;
}

void Baseline::report_stale(diag::Diagnostics& findings) const {
  std::size_t stale = 0;
  const Key* first = nullptr;
  for (const auto& [key, count] : counts_) {
    if (count.found >= count.given) continue;
    stale += count.given - count.found;
    if (first == nullptr) first = &key;
  }
  if (stale == 0) return;
  findings.add(check::kBaselineStale.info,
               fmt::format("{} finding{} of the baseline {} no longer there, such as {} of `{}` in {}: run the same "
                           "command with `--write-baseline` to remove them",
                           stale, stale == 1 ? "" : "s", stale == 1 ? "is" : "are", std::get<1>(*first),
                           std::get<2>(*first), std::get<0>(*first)),
               {file_, {0, 0}});
}

std::string Baseline::text() const {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const auto& [key, count] : counts_) {
    const std::size_t kept = file_ == nullptr ? count.found : std::min(count.found, count.given);
    if (kept == 0) continue;
    const auto& [plant, rule, of] = key;
    findings.push_back({{"plant", plant}, {"rule", rule}, {"of", of}, {"count", kept}});
  }
  std::string text = "{\n  \"symplant-baseline\": 1,\n  \"findings\": [";
  for (std::size_t i = 0; i < findings.size(); ++i) {
    text += (i == 0 ? "\n    " : ",\n    ") +
            findings[i].dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  return text + (findings.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::size_t Baseline::size() const {
  std::size_t size = 0;
  for (const auto& [key, count] : counts_) size += file_ == nullptr ? count.found : std::min(count.found, count.given);
  return size;
}

}  // namespace symplant::findings
