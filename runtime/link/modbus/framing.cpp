// Modbus TCP frames in a stream of bytes, by the Messaging on TCP/IP Implementation Guide V1.0b.
#include "symplant/link/modbus/framing.hpp"

#include "symplant/link/modbus/fields.hpp"

namespace symplant::link::modbus {

namespace {

/// The header up to and including its length field, which counts everything after it: the unit and the PDU.
constexpr std::size_t kBeforeLength = 6;
constexpr std::size_t kMinLength = 2;
constexpr std::size_t kMaxLength = 1 + kMaxPdu;

}  // namespace

Frame parse_frame(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() < kBeforeLength) return {};
  const std::size_t length = field(bytes, 4);
  if (length < kMinLength || length > kMaxLength) return {.kind = Frame::Kind::broken};
  if (bytes.size() < kBeforeLength + length) return {};
  const bool modbus = field(bytes, 2) == 0;
  return {.kind = modbus ? Frame::Kind::complete : Frame::Kind::foreign,
          .consumed = kBeforeLength + length,
          .transaction = field(bytes, 0),
          .unit = bytes[kBeforeLength],
          .pdu = bytes.subspan(kMbapHeader, length - 1)};
}

void write_header(const Frame& frame, std::size_t pdu_size, std::span<std::uint8_t, kMbapHeader> header) noexcept {
  const std::size_t length = pdu_size + 1;
  put_field(header, 0, frame.transaction);
  put_field(header, 2, 0);
  put_field(header, 4, static_cast<std::uint16_t>(length));
  header[6] = frame.unit;
}

}  // namespace symplant::link::modbus
