// Modbus TCP frames in a stream of bytes: the MBAP header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/modbus/codec.hpp"

namespace symplant::link::modbus {

inline constexpr std::size_t kMbapHeader = 7;
inline constexpr std::size_t kMaxFrame = kMbapHeader + kMaxPdu;

/// What stands at the front of the bytes received so far.
struct Frame {
  enum class Kind {
    incomplete,  ///< more bytes are needed; nothing is consumed
    complete,    ///< a request to answer
    foreign,     ///< a whole frame of another protocol: to be dropped without an answer
    broken,      ///< no frame, and no telling where the next one begins: the connection is to be closed
  } kind = Kind::incomplete;
  std::size_t consumed = 0;             ///< bytes that the frame takes
  std::uint16_t transaction = 0;        ///< to be echoed
  std::uint8_t unit = 0;                ///< to be echoed
  std::span<const std::uint8_t> pdu{};  ///< within the bytes given
};

/// Looks at the front of `bytes` and never past the frame that its header announces.
Frame parse_frame(std::span<const std::uint8_t> bytes) noexcept;

/// Writes the header of a reply of `pdu_size` bytes to the request `frame`.
void write_header(const Frame& frame, std::size_t pdu_size, std::span<std::uint8_t, kMbapHeader> header) noexcept;

}  // namespace symplant::link::modbus
