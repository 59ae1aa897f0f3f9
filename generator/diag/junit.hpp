// Findings as JUnit XML, for the test pages of build servers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diag/report.hpp"

namespace symplant::diag {

struct JunitOptions {
  Severity fail_on = Severity::error;  ///< findings of this severity and above are failures
  std::vector<const RuleInfo*> rules;  ///< the rules that were applied, in output order
};

/// One test suite for each plant. A rule without a failing finding is one passed test, with its lesser findings in the
/// output. Each failing finding is a failed test of the class `plant.rule`, named after the subject of the finding.
/// Each finding that plant.json ignores is a skipped test. Each gate is a test. A plant that cannot be read has only
/// its findings, as errors. All times are 0, so that reports of equal runs are equal.
std::string render_junit(std::span<const Report> reports, const JunitOptions& options);

}  // namespace symplant::diag
