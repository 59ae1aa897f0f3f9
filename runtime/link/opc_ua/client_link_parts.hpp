// The link `opc-ua`: the plant is an OPC UA client, the PLC a server.
#pragma once

#include <string>
#include <string_view>

#include "symplant/link/client/parts.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link::opc_ua {

/// Why `rest`, the URL after `opc-ua:`, is invalid; empty if it is valid.
std::string client_fault(std::string_view rest);

/// Opens nothing yet. An invalid map is a usage error; a build without OPC UA is an error of kind environment.
client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

/// What the PLC refused and why, in words.
std::string refusal_text(const tables::Refusal& refusal);

}  // namespace symplant::link::opc_ua
