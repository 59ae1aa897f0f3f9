// Requests of a Modbus client and the replies to them: bytes in, bytes out, no socket, no allocation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/modbus/framing.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint32_t kMostBitsRead = 2000;
inline constexpr std::uint32_t kMostRegistersRead = 125;
inline constexpr std::uint32_t kMostBitsWritten = 1968;
inline constexpr std::uint32_t kMostRegistersWritten = 123;

/// What a request asks for, and what its reply is compared with.
struct ClientRequest {
  enum class Kind : std::uint8_t {
    read,
    write,      ///< several values, by function 15 or 16
    write_one,  ///< by function 5 or 6
    identify,
  } kind = Kind::read;
  Area area = Area::coils;
  std::uint16_t first = 0;
  std::uint16_t count = 0;  ///< 1 of kind write_one
  std::uint16_t value = 0;  ///< of kind write_one; 0 or 1 for a coil
};

/// The header's fields that a reply repeats.
struct ClientHeader {
  std::uint16_t transaction = 0;
  std::uint8_t unit = 0;
};

inline constexpr std::uint8_t kIllegalFunction = 1;  ///< exception

/// Whether the PLC may do the same request soon, after this exception.
constexpr bool is_busy(std::uint8_t exception) { return exception == 5 || exception == 6; }

using FrameBuffer = std::span<std::uint8_t, kMaxFrame>;

/// Function 1 to 6, 15, 16 or 43.
std::uint8_t function_of(const ClientRequest& request) noexcept;

/// Writes the frame of a request of another kind than write; returns its size.
std::size_t encode_request(const ClientHeader& header, const ClientRequest& request, FrameBuffer frame) noexcept;
/// Writes the frame of a request of kind write; returns its size. `values` are as many as the request's count, and 0 or
/// 1 for coils. O(values).
std::size_t encode_write(const ClientHeader& header, const ClientRequest& request,
                         std::span<const std::uint16_t> values, FrameBuffer frame) noexcept;

/// The first frame in the bytes received so far.
struct ClientReply {
  enum class Kind : std::uint8_t {
    incomplete,  ///< more bytes are needed; nothing was consumed
    complete,    ///< the reply to the request, or an exception
    foreign,     ///< a complete frame with another transaction id, such as a late reply: drop it
    broken,      ///< not a reply to this request: close the connection
  } kind = Kind::incomplete;
  std::size_t consumed = 0;              ///< size of the frame in bytes
  std::uint8_t exception = 0;            ///< 0: the PLC did what was requested
  std::span<const std::uint8_t> data{};  ///< of a read request, of the size that its count needs; of function 43 all
  const char* reason = "";               ///< of `broken`: "it is from another unit"
};

/// Parses the first frame of `bytes` and compares all fields that a reply repeats. O(1).
ClientReply parse_client_reply(std::span<const std::uint8_t> bytes, const ClientHeader& header,
                               const ClientRequest& request) noexcept;

/// Copies `count` bits of a reply to the table's bits from `first` on. O(count / 64).
void copy_bits(std::span<const std::uint8_t> data, std::uint32_t count, std::span<std::uint64_t> words,
               std::uint32_t first) noexcept;

/// "exception 02 (illegal data address): ..." and what to do.
std::string exception_text(std::uint8_t code, const ClientRequest& request);

/// "function 15 (write coils) from 800 on: exception 02 (...): ..."; the side is modbus_client.
std::string refusal_text(const tables::Refusal& refusal);

/// Vendor, product and revision of a reply to function 43, in printable ASCII; empty if the reply has none.
std::string identification_text(std::span<const std::uint8_t> data);

}  // namespace symplant::link::modbus
