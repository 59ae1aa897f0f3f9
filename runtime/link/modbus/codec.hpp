// Answers to Modbus requests: bytes in, bytes out, no socket, no allocation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/link/modbus/table_view.hpp"

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
