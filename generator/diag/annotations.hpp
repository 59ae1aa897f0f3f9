// Findings as annotations of build servers: GitHub's workflow commands, GitLab's Code Quality report.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "diag/report.hpp"

namespace symplant::diag {

/// GitHub shows this many annotations of each level in a step.
inline constexpr std::size_t kMostGithubAnnotations = 10;

/// A line `::warning file=io.csv,line=2,col=12,title=SP305 direction-against-address::...` for each finding, the most
/// important of each plant first, at most kMostGithubAnnotations of each level; the rest is counted in a notice. Files
/// in `folder`, which is absolute or empty, are named relative to it. O(findings * log(findings)).
std::string render_github(std::span<const Report> reports, std::string_view folder);

/// A JSON array with an object for each finding: description, check_name, fingerprint, severity and location. An error
/// is `critical`, a warning `major`, a note `info`. O(findings).
std::string render_gitlab(std::span<const Report> reports, std::string_view folder);

}  // namespace symplant::diag
