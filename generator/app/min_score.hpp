// The scores that `check --min-score` requires.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "score/score.hpp"

namespace symplant::app {

struct MinScore {
  std::string written;  ///< `paired=30%`
  bool paired = false;  ///< else accounted
  double least = 0;     ///< 0 to 1
};

/// Reads `paired=0.3` or `accounted=80%`. The error is a message.
base::Result<MinScore, std::string> read_min_score(std::string_view text);

/// Why a score is below the required one; nothing if it is not. Without counted symbols every share is 0.
std::optional<std::string> failed(const MinScore& required, const score::Counts& counts);

}  // namespace symplant::app
