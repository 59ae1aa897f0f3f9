// Requests of a Modbus client and the replies to them, by the Modbus Application Protocol V1.1b3.
#include "symplant/link/modbus/client_codec.hpp"

#include <algorithm>
#include <array>

#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/fields.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::uint8_t kIdentify = 43;
constexpr std::uint8_t kDeviceIdentification = 14;
constexpr std::uint8_t kExceptionBit = 0x80;
constexpr std::size_t kBitsPerByte = 8;

/// What a request of kind write_one has on the wire instead of a count.
std::uint16_t wire_value(const ClientRequest& request) noexcept {
  constexpr std::uint16_t kOn = 0xFF00;
  if (!has_bits(request.area)) return request.value;
  return request.value != 0 ? kOn : 0;
}

std::size_t data_bytes(const ClientRequest& request) noexcept {
  if (!has_bits(request.area)) return std::size_t{2} * request.count;
  return (request.count + kBitsPerByte - 1) / kBitsPerByte;
}

/// Completes a frame whose PDU has `size` bytes.
std::size_t put_header(const ClientHeader& header, const ClientRequest& request, std::size_t size,
                       FrameBuffer frame) noexcept {
  const Frame replied{.transaction = header.transaction, .unit = header.unit};
  write_header(replied, size, frame.first<kMbapHeader>());
  frame[kMbapHeader] = function_of(request);
  return kMbapHeader + size;
}

/// What a PLC that answers a request with exception 01 lacks, and what to do.
std::string without_function(const ClientRequest& request) {
  const bool bits = has_bits(request.area);
  switch (request.kind) {
    case ClientRequest::Kind::write_one:
      return std::string("supports neither function ") + (bits ? "15 nor 5" : "16 nor 6") +
             " for this area; choose another area in the URL";
    case ClientRequest::Kind::write:
      return "does not support function 16, and function 6 writes one register, so that its program could read a half "
             "of this number; use a number of 16 bits, or another PLC";
    default:
      return "does not support function " + std::to_string(function_of(request)) +
             " for this area; choose another area in the URL";
  }
}

ClientReply broken(const char* reason) noexcept { return {.kind = ClientReply::Kind::broken, .reason = reason}; }

}  // namespace

std::uint8_t function_of(const ClientRequest& request) noexcept {
  constexpr std::uint8_t kWriteCoil = 5;
  constexpr std::uint8_t kWriteRegister = 6;
  constexpr std::uint8_t kWriteCoils = 15;
  constexpr std::uint8_t kWriteRegisters = 16;
  if (request.kind == ClientRequest::Kind::identify) return kIdentify;
  if (request.kind == ClientRequest::Kind::write) return has_bits(request.area) ? kWriteCoils : kWriteRegisters;
  if (request.kind == ClientRequest::Kind::write_one) return has_bits(request.area) ? kWriteCoil : kWriteRegister;
  constexpr std::array<std::uint8_t, kAreas> kReads = {1, 2, 3, 4};
  return kReads[static_cast<std::size_t>(request.area)];
}

std::size_t encode_request(const ClientHeader& header, const ClientRequest& request, FrameBuffer frame) noexcept {
  const auto pdu = frame.subspan<kMbapHeader>();
  if (request.kind == ClientRequest::Kind::identify) {
    pdu[1] = kDeviceIdentification;
    pdu[2] = 1;  // the basic objects
    pdu[3] = 0;  // from the first one on
    return put_header(header, request, 4, frame);
  }
  put_field(pdu, 1, request.first);
  put_field(pdu, 3, request.kind == ClientRequest::Kind::write_one ? wire_value(request) : request.count);
  return put_header(header, request, 5, frame);
}

std::size_t encode_write(const ClientHeader& header, const ClientRequest& request,
                         std::span<const std::uint16_t> values, FrameBuffer frame) noexcept {
  constexpr std::size_t kData = 6;
  const auto pdu = frame.subspan<kMbapHeader>();
  const std::size_t size = data_bytes(request);
  put_field(pdu, 1, request.first);
  put_field(pdu, 3, request.count);
  pdu[5] = static_cast<std::uint8_t>(size);
  const auto data = pdu.subspan(kData, size);
  if (has_bits(request.area)) {
    std::fill(data.begin(), data.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto bit = static_cast<unsigned>(values[i] & 1) << (i % kBitsPerByte);
      data[i / kBitsPerByte] = static_cast<std::uint8_t>(data[i / kBitsPerByte] | bit);
    }
  } else {
    for (std::size_t i = 0; i < values.size(); ++i) put_field(data, 2 * i, values[i]);
  }
  return put_header(header, request, kData + size, frame);
}

ClientReply parse_client_reply(std::span<const std::uint8_t> bytes, const ClientHeader& header,
                               const ClientRequest& request) noexcept {
  const Frame frame = parse_frame(bytes);
  if (frame.kind == Frame::Kind::incomplete) return {};
  if (frame.kind == Frame::Kind::broken) return broken("its length is not one of a Modbus frame");
  if (frame.kind == Frame::Kind::foreign) return broken("it is of another protocol than Modbus");
  ClientReply reply{.kind = ClientReply::Kind::complete, .consumed = frame.consumed};
  if (frame.transaction != header.transaction) {
    reply.kind = ClientReply::Kind::foreign;
    return reply;
  }
  if (frame.unit != header.unit) return broken("it is from another unit");
  const std::uint8_t function = function_of(request);
  const auto pdu = frame.pdu;
  if (pdu[0] == (function | kExceptionBit)) {
    if (pdu.size() != 2 || pdu[1] == 0) return broken("its exception has no code");
    reply.exception = pdu[1];
    return reply;
  }
  if (pdu[0] != function) return broken("it is to another function");
  if (request.kind == ClientRequest::Kind::write || request.kind == ClientRequest::Kind::write_one) {
    const std::uint16_t repeated = request.kind == ClientRequest::Kind::write ? request.count : wire_value(request);
    const bool same = pdu.size() == 5 && field(pdu, 1) == request.first && field(pdu, 3) == repeated;
    return same ? reply : broken("it confirms other addresses or another value than those written");
  }
  if (request.kind == ClientRequest::Kind::identify) {
    if (pdu.size() < 7 || pdu[1] != kDeviceIdentification) return broken("it is not a device identification");
    reply.data = pdu.subspan(6);
    return reply;
  }
  const std::size_t size = data_bytes(request);
  if (pdu.size() != 2 + size || pdu[1] != size) return broken("it has another number of bytes than requested");
  reply.data = pdu.subspan(2);
  return reply;
}

void copy_bits(std::span<const std::uint8_t> data, std::uint32_t count, std::span<std::uint64_t> words,
               std::uint32_t first) noexcept {
  for (std::uint32_t done = 0; done < count; done += image::kBitsPerWord) {
    const std::uint32_t part = std::min(image::kBitsPerWord, count - done);
    std::uint64_t bits = 0;
    const std::size_t begin = done / kBitsPerByte;
    const std::size_t end = std::min(begin + sizeof bits, data.size());
    for (std::size_t i = begin; i < end; ++i) bits |= std::uint64_t{data[i]} << (kBitsPerByte * (i - begin));
    image::set_bits(words, first + done, bits, part);
  }
}

std::string exception_text(std::uint8_t code, const ClientRequest& request) {
  const std::string function = std::to_string(function_of(request));
  switch (code) {
    case 1:
      return "exception 01 (illegal function): the PLC " + without_function(request);
    case 2:
      return "exception 02 (illegal data address): the PLC does not have all of these addresses; correct the offset in "
             "the URL or the numbers in `links`, or enlarge the area in the PLC";
    case 3:
      return "exception 03 (illegal data value): the PLC does not accept the value or the number of addresses; check "
             "the area's size and its access rights";
    case 4:
      return "exception 04 (server device failure): the PLC could not execute the request; check its state and "
             "diagnostics";
    case 5:
      return "exception 05 (acknowledge): the PLC needs more time; it is asked again";
    case 6:
      return "exception 06 (server device busy): the PLC is busy; it is asked again, use a longer `poll`";
    case 8:
      return "exception 08 (memory parity error): the PLC cannot read its memory; check its diagnostics";
    case 10:
      return "exception 10 (gateway path unavailable): the gateway has no connection for this unit; check `unit` and "
             "the gateway's settings";
    case 11:
      return "exception 11 (gateway target failed to respond): no device answers as this unit; check `unit` and "
             "whether the PLC is switched on";
    default:
      return "exception " + std::to_string(code) + ": not one of the standard, see the manual of the PLC";
  }
}

std::string refusal_text(const tables::Refusal& refusal) {
  using Kind = ClientRequest::Kind;
  constexpr std::array kRequests = {ClientRequest{Kind::read, Area::coils},
                                    ClientRequest{Kind::read, Area::discrete_inputs},
                                    ClientRequest{Kind::read, Area::holding_registers},
                                    ClientRequest{Kind::read, Area::input_registers},
                                    ClientRequest{Kind::write, Area::coils},
                                    ClientRequest{Kind::write, Area::holding_registers},
                                    ClientRequest{Kind::write_one, Area::coils},
                                    ClientRequest{Kind::write_one, Area::holding_registers}};
  const auto* const found = std::find_if(kRequests.begin(), kRequests.end(), [&](const ClientRequest& request) {
    return function_of(request) == refusal.function;
  });
  const ClientRequest request = found == kRequests.end() ? ClientRequest{Kind::identify} : *found;
  return "function " + std::to_string(refusal.function) + (request.kind == Kind::read ? " (read " : " (write ") +
         area_name(request.area) + "s) from " + std::to_string(refusal.address) +
         " on: " + exception_text(static_cast<std::uint8_t>(refusal.code), request);
}

std::string identification_text(std::span<const std::uint8_t> data) {
  std::string text;
  std::size_t at = 1;  // after the number of objects
  for (std::size_t left = data.empty() ? 0 : data[0]; left != 0 && at + 2 <= data.size(); --left) {
    const std::size_t size = data[at + 1];
    if (at + 2 + size > data.size()) break;
    std::string object;
    for (const std::uint8_t byte : data.subspan(at + 2, size)) {
      if (byte >= ' ' && byte < 0x7F && byte != '`') object += static_cast<char>(byte);
    }
    if (!object.empty()) text.append(text.empty() ? "" : " ").append(object);
    at += 2 + size;
  }
  return text;
}

}  // namespace symplant::link::modbus
