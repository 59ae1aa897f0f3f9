// Warns of options without effect.
#pragma once

#include <iosfwd>

#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// What decides which options have an effect.
struct RunKind {
  bool real;        ///< in real time
  bool linked;      ///< with a link to a PLC
  bool by_plc;      ///< plant time is that of a PLC's clock
  bool programmed;  ///< with a PLC program in lock step
};

/// Warns of given options without effect in this run.
void report_without_effect(const RunOptions& options, const RunKind& run, std::ostream& err);

}  // namespace symplant::host
