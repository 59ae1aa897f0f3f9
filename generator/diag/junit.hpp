// Findings as JUnit XML, for the test pages of build servers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diag/report.hpp"

namespace symplant::diag {

struct JunitOptions {
  Severity fail_on = Severity::error;  ///< findings of this severity and above are failures
  std::vector<const RuleInfo*> rules;  ///< that were looked at, in the order wanted
};

/// One test suite a plant. In it a rule without a failing finding is one test that passes, lesser findings standing in
/// its output; each failing finding is a test that fails, of the class `plant.rule` and the name of what it is about;
/// each finding that plant.json ignores is a test skipped. In a plant that cannot be read there are its findings alone,
/// as errors. No times: they would differ from run to run.
std::string render_junit(std::span<const Report> reports, const JunitOptions& options);

}  // namespace symplant::diag
