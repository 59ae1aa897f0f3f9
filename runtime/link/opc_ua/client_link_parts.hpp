// The link `opc-ua`: the plant is an OPC UA client, the PLC a server.
#pragma once

#include <string_view>

#include "symplant/link/client/parts.hpp"

namespace symplant::link::opc_ua {

/// Reads the files of the security settings, and opens no connection yet. An invalid map or file is a usage error; a
/// build without OPC UA is an error of kind environment.
client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

}  // namespace symplant::link::opc_ua
