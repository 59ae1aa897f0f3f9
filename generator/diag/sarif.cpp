// Findings as SARIF 2.1.0.
#include "diag/sarif.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "diag/encode.hpp"
#include "diag/fingerprint.hpp"
#include "diag/uri.hpp"
#include "diag/visible_text.hpp"

namespace symplant::diag {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kBase = "%SRCROOT%";
constexpr std::size_t kMostRelated = 100;  ///< GitHub shows no more
constexpr std::size_t kMostSnippet = 200;  ///< bytes
constexpr int kFailed = 2;                 ///< exit code of a failed run

/// A finding with the data of its plant.
struct Result {
  const Diagnostic* finding;
  const Report* report;
  const std::string* why;  ///< the reason, if plant.json ignores the finding; else null
  std::string fingerprint = {};
};

Json message(std::string_view text) { return {{"text", sarif_text(text)}}; }

/// The first paragraph of a manual page, as one line.
std::string first_paragraph(std::string_view page) {
  std::string text(page.substr(0, page.find("\n\n")));
  while (text.ends_with('\n')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Json rule_of(const RuleInfo& rule) {
  return {{"id", rule.id},
          {"name", rule.slug},
          {"shortDescription", {{"text", rule.summary}}},
          {"fullDescription", {{"text", first_paragraph(manual_page(rule))}}},
          {"help", {{"text", manual_page(rule)}, {"markdown", manual_page(rule)}}},
          {"defaultConfiguration", {{"level", severity_name(rule.severity)}}}};
}

class SarifRenderer {
 public:
  SarifRenderer(std::span<const Report> reports, const SarifOptions& options) : reports_(reports), options_(options) {}

  Json run() {
    collect();
    const std::size_t all = results_.size();
    results_.resize(std::min(all, kMostSarifResults), Result{nullptr, nullptr, nullptr});
    Json rules = Json::array();
    for (const Result& result : results_) used_rules_.try_emplace(result.finding->rule->id, result.finding->rule);
    std::size_t index = 0;
    for (auto& [id, rule] : used_rules_) {
      rules.push_back(rule_of(*rule.info));
      rule.index = index++;
    }
    Json results = Json::array();
    for (const Result& result : results_) results.push_back(result_of(result));
    const Json driver{{"name", "symplant"},
                      {"version", options_.version},
                      {"semanticVersion", options_.version},
                      {"rules", std::move(rules)}};
    return {
        {"tool", {{"driver", driver}}},
        {"invocations", Json::array({invocation(all - results_.size())})},
        {"originalUriBaseIds", {{kBase, {{"description", {{"text", "the folder in which symplant check was run"}}}}}}},
        {"columnKind", "unicodeCodePoints"},
        {"newlineSequences", {"\r\n", "\n", "\r"}},
        {"results", std::move(results)}};
  }

 private:
  struct UsedRule {
    explicit UsedRule(const RuleInfo* rule) : info(rule) {}
    const RuleInfo* info;
    std::size_t index = 0;
  };

  std::string uri_of(const Diagnostic& finding) const {
    return finding.location.source ? file_uri(finding.location.source->path(), options_.folder) : std::string();
  }

  void collect() {
    Fingerprints fingerprints;
    for (const Report& report : reports_) {
      for (const Diagnostic& finding : report.findings.all()) results_.push_back({&finding, &report, nullptr});
      for (const Ignored& each : report.findings.ignored()) results_.push_back({&each.finding, &report, &each.why});
    }
    for (Result& result : results_) result.fingerprint = fingerprints.next(*result.finding, uri_of(*result.finding));
    std::stable_sort(results_.begin(), results_.end(), [](const Result& a, const Result& b) {
      if ((a.why == nullptr) != (b.why == nullptr)) return a.why == nullptr;
      return a.finding->severity > b.finding->severity;
    });
  }

  Json file_of(std::string_view path) const {
    const std::string uri = file_uri(path, options_.folder);
    Json file{{"uri", uri}};
    if (!uri.starts_with("file://")) file["uriBaseId"] = kBase;
    return file;
  }

  /// Build servers reject a result without a line; line 1 represents a whole file.
  Json location_of(const Location& where, std::string_view otherwise) const {
    Json region{{"startLine", 1}};
    if (where.source && !where.source->text().empty()) region = region_of(*where.source, where.span);
    Json file = file_of(where.source ? std::string_view(where.source->path()) : otherwise);
    return {{"physicalLocation", {{"artifactLocation", std::move(file)}, {"region", std::move(region)}}}};
  }

  static Json region_of(const text::SourceFile& source, text::Span span) {
    const text::Position begin = source.position(span.begin);
    const text::Position end = source.position(span.end);
    Json region{
        {"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
    const std::size_t size = span.end - span.begin;
    const std::string_view snippet = source.text().substr(span.begin, std::min(size, kMostSnippet + 1));
    // Viewers show the snippet as it is.
    if (size > 0 && size <= kMostSnippet && visible(snippet) == snippet) region["snippet"] = {{"text", snippet}};
    return region;
  }

  Json result_of(const Result& result) const {
    const Diagnostic& finding = *result.finding;
    Json json{{"ruleId", finding.rule->id},
              {"ruleIndex", used_rules_.at(finding.rule->id).index},
              {"level", severity_name(finding.severity)},
              {"message", message(finding.message)}};
    json["locations"] = Json::array({location_of(finding.location, result.report->plant)});
    Json related = Json::array();
    for (const Related& each : finding.related) {
      if (related.size() == kMostRelated) break;
      Json location = location_of(each.location, result.report->plant);
      location["id"] = related.size() + 1;
      location["message"] = message(each.message);
      related.push_back(std::move(location));
    }
    if (!related.empty()) json["relatedLocations"] = std::move(related);
    // GitHub uses only the second, or without it the text of the next lines, which are other rows.
    json["partialFingerprints"] = {{"symplant/v1", result.fingerprint},
                                   {"primaryLocationLineHash", result.fingerprint}};
    if (result.why != nullptr) {
      json["suppressions"] =
          Json::array({{{"kind", "external"}, {"status", "accepted"}, {"justification", visible(*result.why)}}});
    }
    if (reports_.size() > 1) json["properties"] = {{"plant", visible(result.report->plant)}};
    return json;
  }

  Json invocation(std::size_t left_out) const {
    Json json{{"executionSuccessful", options_.exit_code < kFailed}, {"exitCode", options_.exit_code}};
    if (left_out != 0) {
      const std::string text =
          std::to_string(left_out) + " findings of the lowest severity are left out, because a run holds at most " +
          std::to_string(kMostSarifResults) + "; choose with --select, or list all with --format json";
      json["toolExecutionNotifications"] = Json::array({{{"level", "warning"}, {"message", message(text)}}});
    }
    return json;
  }

  std::span<const Report> reports_;
  const SarifOptions& options_;
  std::vector<Result> results_;
  std::map<std::string_view, UsedRule> used_rules_;
};

}  // namespace

std::string render_sarif(std::span<const Report> reports, const SarifOptions& options) {
  const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({SarifRenderer(reports, options).run()})}};
  // A message may hold bytes that are not UTF-8; they must not make the whole report fail.
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace symplant::diag
