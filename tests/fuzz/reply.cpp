// Any bytes as the answer of a PLC, and any text as a link's URL: what is taken is complete, and does not depend on how
// the bytes were cut.
#include <algorithm>
#include <array>
#include <vector>

#include "fuzz/target.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/modbus/client_codec.hpp"
#include "symplant/link/slmp/device.hpp"
#include "symplant/link/slmp/framing.hpp"

namespace symplant::fuzz {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Whether `part` lies within `whole`.
bool is_within(Bytes part, Bytes whole) {
  return part.empty() || (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

/// A parser of replies: the oracles that hold for each protocol. Every prefix of a complete reply is incomplete.
template <class Parse>
void try_reply(Bytes bytes, Parse parse) {
  const auto whole = parse(bytes);
  using Kind = decltype(whole.kind);
  require(whole.consumed <= bytes.size(), "a reply consumes more than there is");
  require(is_within(whole.data, bytes), "a reply's data are outside of it");
  if (whole.kind != Kind::complete) return;
  require(is_within(whole.data, bytes.first(whole.consumed)), "a reply's data are outside of its frame");
  for (std::size_t size = 0; size < whole.consumed; ++size) {
    require(parse(bytes.first(size)).kind == Kind::incomplete, "a part of a reply is not incomplete");
  }
  const auto alone = parse(bytes.first(whole.consumed));
  require(alone.kind == Kind::complete && alone.data.size() == whole.data.size(), "a reply depends on what follows it");
}

void try_slmp(std::uint8_t choice, Bytes bytes) {
  using namespace link::slmp;
  Framing framing;
  framing.frame = (choice & 1) != 0 ? FrameType::e4 : FrameType::e3;
  framing.code = (choice & 2) != 0 ? Code::ascii : Code::binary;
  const std::uint16_t serial = (choice & 4) != 0 ? 0x1234 : 0;
  try_reply(bytes, [&](Bytes part) { return parse_reply(part, framing, serial, false); });
  const Reply datagram = parse_reply(bytes, framing, serial, true);
  require(datagram.kind != Reply::Kind::incomplete, "a datagram is incomplete");
  std::array<std::uint16_t, 8> words{};
  DataReader data(datagram.data, framing.code);
  for (std::size_t size = 0; size <= words.size(); ++size) {
    if (data.holds(size)) data.words(std::span(words).first(size));
  }
}

void try_modbus(std::uint8_t choice, Bytes bytes) {
  using namespace link::modbus;
  constexpr std::array kAreas = {Area::coils, Area::discrete_inputs, Area::holding_registers, Area::input_registers};
  constexpr std::array kKinds = {ClientRequest::Kind::read, ClientRequest::Kind::write, ClientRequest::Kind::identify};
  const ClientRequest request{kKinds[choice % kKinds.size()], kAreas[choice / 4 % kAreas.size()], 3,
                              static_cast<std::uint16_t>(1 + choice / 16 % 20)};
  const ClientHeader header{0x0102, 1};
  try_reply(bytes, [&](Bytes part) { return parse_client_reply(part, header, request); });
  const ClientReply reply = parse_client_reply(bytes, header, request);
  if (reply.kind != ClientReply::Kind::complete) return;
  identification_text(reply.data);
  exception_text(reply.exception, request);
  if (request.kind != ClientRequest::Kind::read || reply.exception != 0) return;
  std::array<std::uint64_t, 2> bits{};
  const bool is_bits = request.area == Area::coils || request.area == Area::discrete_inputs;
  if (is_bits) copy_bits(reply.data, request.count, bits, 5);
}

void try_url(std::string_view text) {
  for (const std::string_view scheme : {"slmp:", "modbus-tcp:", "modbus-tcp-server:"}) {
    const std::string fault = link::url_fault(std::string(scheme) + std::string(text));
    require(is_utf8(fault) || !is_utf8(text), "a message is not UTF-8");
  }
  using namespace link::slmp;
  for (const Family family : {Family::q, Family::fx5}) {
    const auto device = parse_device(text, family);
    if (device) require(parse_device(device_text(*device, family), family) == device, "a device's text differs");
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant::fuzz;
  if (size == 0 || size > 4096) return -1;
  const std::uint8_t choice = data[0];
  const std::span rest(data + 1, size - 1);
  if (choice < 0x40) {
    try_slmp(choice, rest);
  } else if (choice < 0x80) {
    try_url(std::string_view(reinterpret_cast<const char*>(rest.data()), rest.size()));
  } else {
    try_modbus(choice & 0x7F, rest);
  }
  return 0;
}
