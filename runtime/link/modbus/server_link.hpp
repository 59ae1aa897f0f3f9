// The link `modbus-tcp-server`: the plant is a Modbus TCP server, the PLC a client.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/net/host_port.hpp"

namespace symplant::link::modbus {

/// Parses `//HOST:PORT`, the link's URL after its scheme.
std::variant<net::HostPort, LinkError> server_address(std::string_view rest);

/// Why `rest`, the link's URL after its scheme, is not `//HOST:PORT`; empty if it is.
std::string address_fault(std::string_view rest);

/// The tables that the link serves; also one with faults. Never an error.
std::variant<LinkMap, LinkError> server_map(std::string_view rest, const LinkChoice& link,
                                            const tables::PlantTables& tables);

/// Creates the server and starts it at that address. Tables must outlive it. An invalid map is a usage error.
LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant);

}  // namespace symplant::link::modbus
