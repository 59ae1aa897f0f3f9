// A refused request of a link, in the 64 bits of a finding's value.
#pragma once

#include <cstdint>

namespace symplant::tables {

/// The side that refused a request, the request, and the reason.
struct Refusal {
  enum class Side : std::uint8_t {
    modbus_server,  ///< the link answered a request of the PLC with an exception
    modbus_client,  ///< the PLC answered a request of the link with an exception
    slmp_client,    ///< the PLC answered a request of the link with an end code
    opc_ua_client,  ///< the PLC answered a request of the link, or a part of it, with a bad status code
  };

  Side side = Side::modbus_server;
  std::uint8_t function = 0;  ///< of Modbus; for SLMP as slmp::refusal_of() packs it
  std::uint16_t code = 0;     ///< the exception or the end code
  std::uint32_t address = 0;  ///< the first address of the request

  bool operator==(const Refusal&) const = default;
};

/// Bits 56 to 63 are the side, 48 to 55 the function, 32 to 47 the code, 0 to 31 the address.
constexpr std::uint64_t pack(const Refusal& refusal) {
  return std::uint64_t{static_cast<std::uint8_t>(refusal.side)} << 56 | std::uint64_t{refusal.function} << 48 |
         std::uint64_t{refusal.code} << 32 | refusal.address;
}

constexpr Refusal unpack_refusal(std::uint64_t value) {
  return {static_cast<Refusal::Side>(value >> 56), static_cast<std::uint8_t>(value >> 48),
          static_cast<std::uint16_t>(value >> 32), static_cast<std::uint32_t>(value)};
}

}  // namespace symplant::tables
