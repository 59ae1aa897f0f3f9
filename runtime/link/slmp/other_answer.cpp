// Explains an answer to a request of an SLMP link that is not a reply in the link's framing.
#include "symplant/link/slmp/other_answer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "symplant/link/client/bytes_text.hpp"

namespace symplant::link::slmp {

namespace {

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view text) {
  return bytes.size() >= text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin(),
                    [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

/// A reply of 1E has the command with its highest bit set, a complete code other than 0, and at most two bytes more.
/// The PLC takes the first byte of a 3E or 4E request for its command.
bool is_1e(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLongest = 4;
  const bool of_request = bytes[0] == 0xD0 || bytes[0] == 0xD4;
  return begins_with(bytes, "D05") || begins_with(bytes, "D45") ||
         (of_request && bytes.size() >= 2 && bytes.size() <= kLongest && bytes[1] != 0);
}

bool is_modbus(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHeader = 6;
  return bytes.size() > kHeader + 1 && bytes[2] == 0 && bytes[3] == 0 &&
         std::size_t{bytes[4]} * 256 + bytes[5] == bytes.size() - kHeader;
}

}  // namespace

std::string other_answer(std::span<const std::uint8_t> bytes, const Framing& framing) {
  using namespace std::string_view_literals;
  struct Beginning {
    std::string_view text;
    FrameType frame;
    Code code;
  };
  constexpr std::array kBeginnings = {
      Beginning{"\xD0\0"sv, FrameType::e3, Code::binary}, Beginning{"\xD4\0"sv, FrameType::e4, Code::binary},
      Beginning{"D000"sv, FrameType::e3, Code::ascii}, Beginning{"D400"sv, FrameType::e4, Code::ascii}};
  for (const Beginning& one : kBeginnings) {
    if (!begins_with(bytes, one.text)) continue;
    std::string settings;
    if (one.code != framing.code) settings += one.code == Code::ascii ? " `code=ascii`" : " `code=binary`";
    if (one.frame != framing.frame) settings += one.frame == FrameType::e3 ? " `frame=3e`" : " `frame=4e`";
    if (!settings.empty()) return "an SLMP port answers in another form: set" + settings;
    return "an SLMP port answers with a frame that is cut or damaged";
  }
  if (is_1e(bytes)) {
    return "a PLC answers that speaks 1E frames only, such as an FX3 with an Ethernet adapter; use its Modbus server "
           "with `modbus-tcp://`, if it has one";
  }
  if (is_modbus(bytes)) return "a Modbus server answers: use `modbus-tcp://` for this port";
  return "the answer is not from an SLMP port, " + client::bytes_text(bytes) + ": check the address and the port";
}

}  // namespace symplant::link::slmp
