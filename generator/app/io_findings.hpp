// Findings about patterns of rows that are I/O.
#pragma once

#include <memory>

#include "description/plant_source.hpp"
#include "diag/diagnostic.hpp"
#include "name/io_rows.hpp"

namespace symplant::app {

/// Adds a finding for each pattern that matches no internal row, and for rows that both directions match. `source` is
/// the plant.json with the patterns; patterns of the command line have no location.
void add_io_findings(const name::IoRows& io, const std::shared_ptr<const description::PlantSource>& source,
                     diag::Diagnostics& diagnostics);

}  // namespace symplant::app
