// symplant generate --fmu: the plant as an FMU.
#pragma once

#include <string>
#include <vector>

#include "app/context.hpp"
#include "app/pipeline.hpp"

namespace symplant::app {

struct FmuOptions {
  const std::string& file;
  const std::vector<std::string>& libraries;  ///< `PLATFORM=FILE`; none: those of the tool
  const std::string& depfile;                 ///< empty: none
  bool check;                                 ///< write nothing, but compare
};

/// Writes the FMU, or reports on `context.err` why not and sets the exit code.
void generate_fmu(const FmuOptions& options, const Compiled& compiled, Context& context);

}  // namespace symplant::app
