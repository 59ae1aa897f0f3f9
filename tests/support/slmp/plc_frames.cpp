// Frames 3E and 4E: headers of requests and of replies.
#include "support/slmp/plc_frames.hpp"

#include "support/slmp/plc_fields.hpp"

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kRequest3e = 0x5000;
constexpr std::uint32_t kRequest4e = 0x5400;
constexpr std::uint32_t kReply3e = 0xD000;
constexpr std::uint32_t kReply4e = 0xD400;
constexpr std::size_t kFixedPart = 6;  // timer, command, subcommand

std::size_t unit_of(Code code) { return code == Code::ascii ? 2 : 1; }

/// Subheader, serial number, route, length: bytes up to the end of the length field.
std::size_t header_size(bool is_4e, Code code) { return (is_4e ? 13 : 9) * unit_of(code); }

Route read_route(FieldReader& fields) {
  Route route;
  route.network = static_cast<std::uint8_t>(fields.number(1));
  route.station = static_cast<std::uint8_t>(fields.number(1));
  route.module_io = static_cast<std::uint16_t>(fields.number(2));
  route.multidrop = static_cast<std::uint8_t>(fields.number(1));
  return route;
}

void write_route(FieldWriter& fields, const Route& route) {
  fields.number(route.network, 1);
  fields.number(route.station, 1);
  fields.number(route.module_io, 2);
  fields.number(route.multidrop, 1);
}

/// Whether the bytes can be the beginning of a subheader, and then whether it is that of 4E.
bool read_subheader(std::span<const std::uint8_t> bytes, Code code, bool& is_4e) {
  FieldReader fields(bytes, code);
  const std::uint32_t subheader = fields.subheader();
  is_4e = subheader == kRequest4e;
  return !fields.is_malformed() && (is_4e || subheader == kRequest3e);
}

}  // namespace

FoundRequest find_request(std::span<const std::uint8_t> bytes, Code code) {
  FoundRequest result;
  const std::size_t unit = unit_of(code);
  if (!bytes.empty() && bytes.front() != (code == Code::ascii ? '5' : 0x50) &&
      (code == Code::ascii || bytes.front() != 0x54)) {
    result.found = Found::foreign;
    return result;
  }
  if (bytes.size() < 2 * unit) return result;
  RequestFrame& frame = result.frame;
  result.found = read_subheader(bytes, code, frame.is_4e) ? Found::part : Found::foreign;
  const std::size_t header = header_size(frame.is_4e, code);
  if (result.found == Found::foreign || bytes.size() < header) return result;

  FieldReader fields(bytes.subspan(2 * unit), code);
  if (frame.is_4e) {
    frame.serial = static_cast<std::uint16_t>(fields.number(2));
    fields.number(2);
  }
  frame.route = read_route(fields);
  const std::size_t length = fields.number(2);
  if (fields.is_malformed() || length < kFixedPart * unit) {
    result.found = Found::foreign;
    return result;
  }
  result.size = header + length;
  if (bytes.size() < result.size) return result;

  FieldReader content(bytes.subspan(header, length), code);
  frame.timer = static_cast<std::uint16_t>(content.number(2));
  frame.command = static_cast<std::uint16_t>(content.number(2));
  frame.subcommand = static_cast<std::uint16_t>(content.number(2));
  frame.payload.assign(content.rest().begin(), content.rest().end());
  result.found = content.is_malformed() ? Found::foreign : Found::request;
  return result;
}

Bytes encode_reply(const RequestFrame& request, Code code, std::uint16_t end_code, const Bytes& data) {
  FieldWriter content(code);
  content.number(end_code, 2);
  if (end_code == 0) {
    content.raw(data);
  } else {
    write_route(content, request.route);
    content.number(request.command, 2);
    content.number(request.subcommand, 2);
  }
  FieldWriter fields(code);
  fields.subheader(request.is_4e ? kReply4e : kReply3e);
  if (request.is_4e) {
    fields.number(request.serial, 2);
    fields.number(0, 2);
  }
  write_route(fields, request.route);
  fields.number(static_cast<std::uint32_t>(content.bytes().size()), 2);
  fields.raw(content.bytes());
  return fields.bytes();
}

ReplyLayout reply_layout(bool is_4e, Code code) {
  const std::size_t unit = unit_of(code);
  const std::size_t route = is_4e ? 6 : 2;
  return {unit, 2 * unit, route * unit, (route + 5) * unit, (route + 7) * unit, (route + 9) * unit};
}

}  // namespace symplant::test::slmp
