// The link `modbus-tcp-server`: the plant is a Modbus TCP server, the PLC a client.
#pragma once

#include <string>
#include <string_view>

#include "symplant/link/link.hpp"

namespace symplant::link::modbus {

/// Why `rest`, the link's URL behind its scheme, is not `//HOST:PORT`; empty where it is.
std::string address_fault(std::string_view rest);

/// Makes and starts the server on it. Tables must outlive it. A map with a fault is a usage error.
LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant);

}  // namespace symplant::link::modbus
