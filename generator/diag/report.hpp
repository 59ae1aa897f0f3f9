// What one run found in one plant, for formats that tell of several plants.
#pragma once

#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

struct Report {
  std::string plant;  ///< as the user named it
  Diagnostics findings;
  bool readable = true;  ///< false: there is no plant, and most rules have not looked at it
};

}  // namespace symplant::diag
