// Answers to Modbus requests: bytes in, bytes out, no socket, no allocation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/modbus/pdu.hpp"
#include "symplant/link/modbus/tables.hpp"

namespace symplant::link::modbus {

/// Answers one request PDU (function code and data) from the tables, and writes its data to them. An exception changes
/// nothing. Checks come in the order of the specification's state diagrams: function (01), format and quantity (03),
/// address (02); for mask write (22) address, then format. A request with a reserved function code, from 128 on, gets
/// no reply.
Answer answer_request(std::span<const std::uint8_t> request, const Tables& tables, const Identity& identity,
                      std::span<std::uint8_t, kMaxPdu> reply) noexcept;

/// Rejects the request with `exception`, without looking at its data. No reply if answer_request() would give no reply.
Answer refuse_request(std::span<const std::uint8_t> request, Exception exception,
                      std::span<std::uint8_t, kMaxPdu> reply) noexcept;

}  // namespace symplant::link::modbus
