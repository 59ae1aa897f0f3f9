// Modbus TCP frames in a stream of bytes: the MBAP header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/modbus/codec.hpp"

namespace symplant::link::modbus {

inline constexpr std::size_t kMbapHeader = 7;
inline constexpr std::size_t kMaxFrame = kMbapHeader + kMaxPdu;

/// The first frame in the bytes received so far.
struct Frame {
  enum class Kind {
    incomplete,  ///< more bytes are needed; nothing was consumed
    complete,    ///< a request to answer
    foreign,     ///< a complete frame of another protocol: drop it without an answer
    broken,      ///< not a frame, and the start of the next one is unknown: close the connection
  } kind = Kind::incomplete;
  std::size_t consumed = 0;             ///< size of the frame in bytes
  std::uint16_t transaction = 0;        ///< to be echoed
  std::uint8_t unit = 0;                ///< to be echoed
  std::span<const std::uint8_t> pdu{};  ///< within the bytes given
};

/// Parses the first frame of `bytes`; never reads past the length in its header.
Frame parse_frame(std::span<const std::uint8_t> bytes) noexcept;

/// Writes the header of a reply of `pdu_size` bytes to the request `frame`.
void write_header(const Frame& frame, std::size_t pdu_size, std::span<std::uint8_t, kMbapHeader> header) noexcept;

}  // namespace symplant::link::modbus
