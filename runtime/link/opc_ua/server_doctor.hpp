// Listens as an OPC UA server and notes what clients read and write.
#pragma once

#include <string_view>

#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// Serves the nodes of a link at their initial values. `rest`: the link's URL after its scheme. A build without OPC UA
/// is an error of kind environment.
doctor::Examined examine_server(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                                const doctor::Options& options);

}  // namespace symplant::link::opc_ua
