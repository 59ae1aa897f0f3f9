// The link `opc-ua`: the plant is an OPC UA client, the PLC a server.
#pragma once

#include <string_view>

#include "symplant/link/client/parts.hpp"

namespace symplant::link::opc_ua {

/// Opens nothing yet. An invalid map is a usage error; a build without OPC UA is an error of kind environment.
client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

}  // namespace symplant::link::opc_ua
