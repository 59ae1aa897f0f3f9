// The rules of plant.json, and reporting its faults as findings.
#include "description/description_rules.hpp"

#include <array>

#include "description/rules/condition_not_understood.hpp"
#include "description/rules/contradictory_patterns.hpp"
#include "description/rules/description_contradiction.hpp"
#include "description/rules/description_not_json.hpp"
#include "description/rules/description_schema.hpp"
#include "description/rules/description_unknown_name.hpp"
#include "description/rules/left_out_for_some.hpp"
#include "description/rules/pattern_matches_nothing.hpp"

namespace symplant::description {
namespace {

constexpr std::array<const diag::RuleInfo*, 8> kRules{
    &kDescriptionNotJson,    &kDescriptionSchema, &kDescriptionUnknownName, &kContradictoryPatterns,
    &kPatternMatchesNothing, &kLeftOutForSome,    &kConditionNotUnderstood, &kDescriptionContradiction};

text::Span span_of(const json::Span& span) { return {span.begin, span.end}; }

}  // namespace

std::span<const diag::RuleInfo* const> rules() { return kRules; }

const diag::RuleInfo& rule_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::contradiction:
      return kDescriptionContradiction;
    case FaultKind::shape:
      return kDescriptionSchema;
    case FaultKind::unknown_name:
      return kDescriptionUnknownName;
    case FaultKind::patterns:
      return kContradictoryPatterns;
    case FaultKind::matches_nothing:
      return kPatternMatchesNothing;
    case FaultKind::left_out:
      return kLeftOutForSome;
    case FaultKind::condition:
      return kConditionNotUnderstood;
  }
  return kDescriptionContradiction;
}

void add_empty_file(const std::string& path, diag::Diagnostics& diagnostics) {
  diagnostics.add(kDescriptionNotJson,
                  "the file `" + path +
                      "` is empty; a plant description begins as `{ \"symplant\": 1, \"symbols\": "
                      "[\"list.csv\"] }`",
                  {std::make_shared<text::SourceFile>(path, ""), {}});
}

void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const json::Placed> faults,
                  diag::Diagnostics& diagnostics, const diag::RuleInfo& rule) {
  for (const json::Placed& fault : faults) {
    std::vector<diag::Related> related;
    if (fault.related) related.push_back({{source, span_of(fault.related->span)}, fault.related->message});
    diagnostics.add(rule, fault.message, {source, span_of(fault.span)}, std::move(related));
  }
}

void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const json::Placed> faults,
                  diag::Diagnostics& diagnostics) {
  add_findings(source, faults, diagnostics, kDescriptionNotJson);
}

void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const DescriptionFault> faults,
                  diag::Diagnostics& diagnostics, RuleOf rule_of_kind) {
  add_findings(PlantSource(source), faults, diagnostics, rule_of_kind);
}

void add_findings(const PlantSource& source, std::span<const DescriptionFault> faults, diag::Diagnostics& diagnostics,
                  RuleOf rule_of_kind) {
  if (faults.empty()) return;
  std::vector<json::Fault> wanted;
  wanted.reserve(faults.size());
  for (const DescriptionFault& fault : faults) wanted.push_back({fault.pointer, {}, fault.column, fault.at_key});
  for (const DescriptionFault& fault : faults) {
    if (!fault.related.empty()) wanted.push_back({fault.related, {}, 0, fault.at_key});
  }
  const std::vector<PlantSource::Place> places = source.places(wanted);
  std::size_t next_related = faults.size();
  for (std::size_t i = 0; i < faults.size(); ++i) {
    std::vector<diag::Related> related;
    if (!faults[i].related.empty()) {
      related.push_back({source.location(places[next_related++]), faults[i].related_message});
    }
    diagnostics.add(rule_of_kind(faults[i].kind), faults[i].message, source.location(places[i]), std::move(related));
  }
}

}  // namespace symplant::description
