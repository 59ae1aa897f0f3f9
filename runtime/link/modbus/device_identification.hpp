// Function 43/14 of Modbus, read device identification.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/modbus/pdu.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint8_t kEncapsulatedInterface = 43;

struct Identified {
  std::size_t size = 0;  ///< bytes of the reply
  Exception exception = Exception::none;
};

/// Answers a request of function 43: the basic objects 0 to 2, as a stream or one of them, by the Modbus Application
/// Protocol V1.1b3, section 6.21. Exceptions: 01 for an interface other than 14, 03 for a wrong length or code, 02 for
/// one unknown object. After an exception the content of `reply` is undefined.
Identified identify(std::span<const std::uint8_t> request, const Identity& identity,
                    std::span<std::uint8_t, kMaxPdu> reply) noexcept;

}  // namespace symplant::link::modbus
