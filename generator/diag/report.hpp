// The findings of one run in one plant, for formats with several plants.
#pragma once

#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

struct Report {
  std::string plant;  ///< as the user wrote it
  Diagnostics findings;
  bool readable = true;  ///< false: the plant could not be read, and most rules were not applied
};

}  // namespace symplant::diag
