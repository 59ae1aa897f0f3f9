// Listens on a server link and notes what the PLC touches.
#pragma once

#include <string_view>

#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::modbus {

/// Serves the map of a server link at its initial values. `rest`: the link's URL after its scheme.
doctor::Examined examine_server(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                                const doctor::Options& options);

}  // namespace symplant::link::modbus
