// What a Modbus PDU is made of: its limit, exception codes, the outcome of a request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "symplant/link/modbus/io_map.hpp"

namespace symplant::link::modbus {

inline constexpr std::size_t kMaxPdu = 253;

/// Exception codes of the Modbus Application Protocol V1.1b3, section 7.
enum class Exception : std::uint8_t {
  none = 0,
  illegal_function = 1,
  illegal_data_address = 2,
  illegal_data_value = 3,
  server_device_busy = 6,
};

/// The result of answering a request.
struct Answer {
  std::size_t size = 0;  ///< bytes of the reply; 0: no reply is due
  Exception exception = Exception::none;
  Table written = Table::coil;  ///< the table that was written, if `count` is not 0
  std::uint16_t first = 0;      ///< first address written
  std::uint16_t count = 0;      ///< number of addresses written
  Table read = Table::coil;     ///< the table that was read, if `read_count` is not 0
  std::uint16_t read_first = 0;
  std::uint16_t read_count = 0;
};

/// Identity of the server for function 43/14. Texts are sent in printable ASCII, each cut after kMaxObject bytes.
struct Identity {
  static constexpr std::size_t kMaxObject = 64;

  std::string_view vendor;
  std::string_view product;
  std::string_view revision;
};

}  // namespace symplant::link::modbus
