// Replies with changed bytes.
#include "support/slmp/distortions.hpp"

#include <algorithm>
#include <array>

#include "support/slmp/plc_fields.hpp"

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kBusy = 0xCEE0;

/// Overwrites a number of 1 or 2 bytes at an offset of the wire.
void put_number(Bytes& reply, std::size_t at, std::uint32_t value, std::size_t bytes, Code code) {
  FieldWriter field(code);
  field.number(value, bytes);
  std::copy(field.bytes().begin(), field.bytes().end(), reply.begin() + static_cast<std::ptrdiff_t>(at));
}

void fit_length(Bytes& reply, const ReplyLayout& layout, Code code) {
  put_number(reply, layout.length, static_cast<std::uint32_t>(reply.size() - layout.end_code), 2, code);
}

/// An error reply with the first `block` bytes of the error information block.
Bytes error_with(const Exchange& exchange, const ReplyLayout& layout, std::size_t block) {
  Bytes reply = encode_reply(exchange.request, exchange.code, kBusy, {});
  reply.resize(layout.data + block * layout.unit);
  fit_length(reply, layout, exchange.code);
  return reply;
}

Bytes with_length(const Exchange& exchange, const ReplyLayout& layout, std::ptrdiff_t change) {
  Bytes reply = exchange.reply;
  const auto length = static_cast<std::ptrdiff_t>(reply.size() - layout.end_code);
  const std::ptrdiff_t lie = std::max<std::ptrdiff_t>(0, length + change);
  put_number(reply, layout.length, static_cast<std::uint32_t>(lie), 2, exchange.code);
  return reply;
}

Bytes with_other_route(const Exchange& exchange, const ReplyLayout& layout, Draws& draws) {
  Bytes reply = exchange.reply;
  const Route& route = exchange.request.route;
  const auto change = static_cast<std::uint32_t>(1 + draws.below(100));
  if (draws.below(2) == 0) put_number(reply, layout.route, (route.network + change) & 0xFFU, 1, exchange.code);
  put_number(reply, layout.route + layout.unit, (route.station + change) & 0xFFU, 1, exchange.code);
  return reply;
}

Bytes with_other_subheader(const Exchange& exchange) {
  Bytes reply = exchange.reply;
  FieldWriter subheader(exchange.code);
  subheader.subheader(exchange.request.is_4e ? 0xD000 : 0xD400);
  std::copy(subheader.bytes().begin(), subheader.bytes().end(), reply.begin());
  return reply;
}

Bytes random_bytes(std::size_t count, Draws& draws) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(draws.below(256));
  return bytes;
}

Bytes in_other_code(const Exchange& exchange) {
  const Code other = exchange.code == Code::binary ? Code::ascii : Code::binary;
  FieldWriter data(other);
  data.words({0x1234});
  return encode_reply(exchange.request, other, exchange.end_code, data.bytes());
}

/// Of requests that can never succeed, that may not now, and that may soon.
constexpr std::array<std::uint16_t, 7> kEndCodes = {0x0055, 0x4031, 0xC051, 0xC056, 0xC05B, 0xC05F, 0x4ABC};

Bytes with_other_size(const Exchange& exchange, const ReplyLayout& layout, bool is_more) {
  Bytes reply = exchange.reply;
  const std::size_t change = 2 * layout.unit;
  const std::size_t least = layout.data;
  reply.resize(is_more ? reply.size() + change : std::max(least, reply.size() - change), exchange.reply.back());
  fit_length(reply, layout, exchange.code);
  return reply;
}

}  // namespace

std::size_t Draws::below(std::size_t bound) {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t mixed = state_;
  mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
  return bound == 0 ? 0 : static_cast<std::size_t>((mixed ^ (mixed >> 31U)) % bound);
}

Bytes joined(const Bytes& first, const Bytes& second) {
  Bytes all = first;
  all.insert(all.end(), second.begin(), second.end());
  return all;
}

Bytes front(const Bytes& bytes, std::size_t count) {
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

Bytes back(const Bytes& bytes, std::size_t from) {
  return {bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end()};
}

Bytes distorted(Distortion kind, const Exchange& exchange, Draws& draws) {
  const ReplyLayout layout = reply_layout(exchange.request.is_4e, exchange.code);
  const std::ptrdiff_t some = static_cast<std::ptrdiff_t>((1 + draws.below(4)) * layout.unit);
  Bytes reply = exchange.reply;
  switch (kind) {
    case Distortion::foreign_serial:
      put_number(reply, layout.serial, (exchange.request.serial - 1U) & 0xFFFFU, 2, exchange.code);
      return reply;
    case Distortion::wrong_subheader:
      return with_other_subheader(exchange);
    case Distortion::wrong_route:
      return with_other_route(exchange, layout, draws);
    case Distortion::length_too_long:
      return with_length(exchange, layout, some);
    case Distortion::length_too_short:
      return with_length(exchange, layout, -some);
    case Distortion::length_huge:
      put_number(reply, layout.length, 0xFFFF, 2, exchange.code);
      return reply;
    case Distortion::garbage:
      return random_bytes(1 + draws.below(200), draws);
    case Distortion::end_code:
      return encode_reply(exchange.request, exchange.code, kEndCodes[draws.below(kEndCodes.size())], {});
    case Distortion::bare_error:
      return error_with(exchange, layout, 0);
    case Distortion::short_error:
      return error_with(exchange, layout, 1 + draws.below(8));
    case Distortion::extra_data:
      return with_other_size(exchange, layout, true);
    case Distortion::missing_data:
      return with_other_size(exchange, layout, false);
    case Distortion::trailing_bytes:
      return joined(reply, random_bytes(1 + draws.below(20), draws));
    case Distortion::other_code:
      return in_other_code(exchange);
    default:
      return reply;
  }
}

}  // namespace symplant::test::slmp
