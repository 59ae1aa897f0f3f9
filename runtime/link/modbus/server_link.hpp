// The link `modbus-tcp-server`: the plant is a Modbus TCP server, the PLC a client.
#pragma once

#include <string_view>

#include "symplant/link/link.hpp"

namespace symplant::link::modbus {

/// Makes and starts the server on `rest`, which is `//HOST:PORT`, with a controller's symbols. Tables must outlive it.
LinkResult open_server_link(std::string_view rest, const core::PlantTables& tables, std::uint32_t controller,
                            const core::Plant* plant);

}  // namespace symplant::link::modbus
