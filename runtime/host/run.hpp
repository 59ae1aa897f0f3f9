// Runs a plant: the same for generated tables and for those made at run time.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "symplant/core/tables.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// Tells what the plant is (with `more` lines), then runs it by the options until it ends or a signal (SIGINT, SIGTERM)
/// comes. Results go to `out`, messages to `err`. Gives the exit code.
int run(const core::PlantTables& tables, const RunOptions& options, std::ostream& out, std::ostream& err,
        const std::vector<std::string>& more = {});

}  // namespace symplant::host
