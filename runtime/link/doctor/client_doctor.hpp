// Examines a link that goes to the PLC.
#pragma once

#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"

namespace symplant::link::doctor {

Report examine_client(client::ClientParts parts, const tables::PlantTables& tables, const Options& options);

}  // namespace symplant::link::doctor
