// The rules of plant.json, and its faults as findings.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "description/description.hpp"
#include "diag/diagnostic.hpp"
#include "symplant/json/location.hpp"

namespace symplant::description {

/// By id.
std::span<const diag::RuleInfo* const> rules();

/// The file holds nothing.
void add_empty_file(const std::string& path, diag::Diagnostics& diagnostics);

/// Why the text is no JSON.
void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const json::Placed> faults,
                  diag::Diagnostics& diagnostics);

/// Faults and warnings at their places in the file. One pass over its text for all of them.
void add_findings(const std::shared_ptr<const text::SourceFile>& source, std::span<const DescriptionFault> faults,
                  diag::Diagnostics& diagnostics);

}  // namespace symplant::description
