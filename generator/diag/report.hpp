// The findings of one run in one plant, for formats with several plants.
#pragma once

#include <string>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// A requirement on the plant as a whole, which is not a finding.
struct Gate {
  std::string name;     ///< `min-score paired=0.3`
  std::string failure;  ///< why it is not met; empty if it is
};

struct Report {
  std::string plant;  ///< as the user wrote it
  Diagnostics findings;
  bool readable = true;  ///< false: the plant could not be read, and most rules were not applied
  std::vector<Gate> gates = {};
};

}  // namespace symplant::diag
