// The link `modbus-tcp`: the plant is a Modbus TCP client, the PLC a server.
#pragma once

#include <string>
#include <string_view>

#include "symplant/link/client/parts.hpp"

namespace symplant::link::modbus {

/// Why `rest`, the URL after `modbus-tcp:`, is invalid; empty if it is valid.
std::string client_fault(std::string_view rest);

/// Opens nothing yet. An invalid map is a usage error.
client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

}  // namespace symplant::link::modbus
