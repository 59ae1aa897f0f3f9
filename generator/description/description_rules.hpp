// The rules of plant.json, and reporting its faults as findings.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "description/description.hpp"
#include "description/plant_source.hpp"
#include "diag/diagnostic.hpp"
#include "symplant/json/location.hpp"

namespace symplant::description {

/// The rules, by id.
std::span<const diag::RuleInfo* const> rules();

/// Adds the finding that the file is empty.
void add_empty_file(const std::string& path, diag::Diagnostics& diagnostics);

/// The rule of a kind of fault in plant.json.
const diag::RuleInfo& rule_of(FaultKind kind);
using RuleOf = const diag::RuleInfo& (*)(FaultKind kind);

/// Adds the faults of the JSON syntax.
void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const json::Placed> faults,
                  diag::Diagnostics& diagnostics, const diag::RuleInfo& rule);
void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const json::Placed> faults,
                  diag::Diagnostics& diagnostics);

/// Adds faults and warnings at their locations in the file. One pass over its text for all of them.
void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const DescriptionFault> faults,
                  diag::Diagnostics& diagnostics, RuleOf rule_of_kind = &rule_of);
/// Adds faults and warnings of a whole description, each in the file that it is about.
void add_findings(const PlantSource& source, std::span<const DescriptionFault> faults, diag::Diagnostics& diagnostics,
                  RuleOf rule_of_kind = &rule_of);

}  // namespace symplant::description
