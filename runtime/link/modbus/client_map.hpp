// Where each symbol lies in a PLC that is a Modbus server.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint32_t kBitsInRegister = 16;

/// Whether a table's bits are 16 to a register.
constexpr bool is_packed(const Placement& placement, Table table) {
  return !has_bits(placement.area) && has_bits(table);
}

/// The coil or register of a table's number.
constexpr std::uint32_t address_of(const Placement& placement, Table table, std::uint32_t number) {
  return placement.offset + (is_packed(placement, table) ? number / kBitsInRegister : number);
}

/// The map of a controller's symbols, by make_io_map(): a number there plus an offset is the address in the PLC. The
/// status block is part of it only if the settings give its register. Errors, of kind usage: events without a choice
/// of their area, an address above 65,535, two tables that overlap in the PLC, a watchdog. A map with faults is
/// returned as it is. O(symbols log symbols).
std::variant<IoMap, LinkError> make_client_map(const tables::PlantTables& tables, std::uint32_t controller,
                                               const LinkSettings& link, const ClientSettings& settings);

/// "coil 5", "holding registers 10-11", "holding register 1024.3", for each point of the map.
std::vector<std::string> client_addresses(const IoMap& map, const ClientSettings& settings);

}  // namespace symplant::link::modbus
