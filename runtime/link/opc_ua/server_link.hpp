// The link `opc-ua-server`: the plant is an OPC UA server.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"

namespace symplant::link::opc_ua {

/// Why `rest`, the URL after `opc-ua-server:`, is invalid; empty if it is valid.
std::string server_fault(std::string_view rest);

/// The node ids of all symbols of the controller.
std::variant<LinkMap, LinkError> server_map(std::string_view rest, const LinkChoice& link,
                                            const tables::PlantTables& tables);

/// Creates the server and starts it at its address. Tables and plant must outlive it. A build without OPC UA is an
/// error of kind environment.
LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant);

}  // namespace symplant::link::opc_ua
