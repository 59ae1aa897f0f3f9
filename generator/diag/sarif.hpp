// Findings as SARIF 2.1.0, for code scanning on build servers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "diag/report.hpp"

namespace symplant::diag {

/// The most results in a run that GitHub accepts.
inline constexpr std::size_t kMostSarifResults = 25'000;

struct SarifOptions {
  std::string_view version;  ///< the tool's
  std::string_view folder;   ///< absolute; files in it are named relative to it (see file_uri)
  int exit_code = 0;         ///< the exit code of the run; 2 is a failed run
};

/// One run for all plants: errors first, then warnings, notes, and the findings that plant.json ignores as suppressed
/// results; each group in the order of plants and findings. Results beyond kMostSarifResults are counted in a
/// notification of the run. Only rules with results are described. O(findings).
std::string render_sarif(std::span<const Report> reports, const SarifOptions& options);

}  // namespace symplant::diag
