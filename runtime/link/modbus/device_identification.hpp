// Function 43/14 of Modbus, read device identification: who the server is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/modbus/codec.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint8_t kEncapsulatedInterface = 43;

struct Identified {
  std::size_t size = 0;  ///< bytes of the reply
  Exception exception = Exception::none;
};

/// Answers a request of function 43: the basic objects 0 to 2, as a stream or one of them, by the Modbus Application
/// Protocol V1.1b3, section 6.21. Another interface than 14 is 01, a wrong length or code 03, one object that is not
/// there 02; where there is an exception nothing useful is in `reply`.
Identified identify(std::span<const std::uint8_t> request, const Identity& identity,
                    std::span<std::uint8_t, kMaxPdu> reply) noexcept;

}  // namespace symplant::link::modbus
