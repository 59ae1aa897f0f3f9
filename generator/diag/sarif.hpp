// Findings as SARIF 2.1.0, for code scanning on build servers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "diag/report.hpp"

namespace symplant::diag {

/// GitHub refuses a run with more.
inline constexpr std::size_t kMostSarifResults = 25'000;

struct SarifOptions {
  std::string_view version;  ///< the tool's
  std::string_view folder;   ///< absolute; files in it are named relative to it (see file_uri)
  int exit_code = 0;         ///< what the run ends with; 2 is a run that failed
};

/// One run for all plants: errors first, then warnings, notes, and what plant.json ignores as suppressed results; of
/// each in the order of plants and of finding. What goes beyond kMostSarifResults is counted in a notification of the
/// run. Only rules with results are described. O(findings).
std::string render_sarif(std::span<const Report> reports, const SarifOptions& options);

}  // namespace symplant::diag
