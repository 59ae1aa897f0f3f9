// Listens on a server link and notes what the PLC touches.
#pragma once

#include <variant>

#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"
#include "symplant/link/net/host_port.hpp"

namespace symplant::link::doctor {

/// Serves the map of a Modbus server link at its initial values.
std::variant<Report, LinkError> examine_modbus_server(const net::HostPort& address, const LinkChoice& link,
                                                      const tables::PlantTables& tables, const Options& options);

}  // namespace symplant::link::doctor
