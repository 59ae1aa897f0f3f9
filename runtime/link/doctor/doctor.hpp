// Examines a link against a live PLC, without a plant.
#pragma once

#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::doctor {

/// A client link connects, identifies the PLC, reads all mapped points and watches them; it writes only for the write
/// test. A server link listens and notes what the PLC touches. Blocks for the duration and the timeouts of the link.
/// Errors are those of opening the link.
Examined examine(const LinkChoice& link, const tables::PlantTables& tables, const Options& options);

}  // namespace symplant::link::doctor
