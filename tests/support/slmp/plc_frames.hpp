// Frames 3E and 4E, binary and ASCII: headers of requests and of replies (sections 1.1 to 1.3 of the SLMP reference).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "support/slmp/plc_devices.hpp"

namespace symplant::test::slmp {

using Bytes = std::vector<std::uint8_t>;

/// The station that a request is for. The default is the PLC that the connection leads to.
struct Route {
  std::uint8_t network = 0;
  std::uint8_t station = 0xFF;  ///< "PC number"
  std::uint16_t module_io = 0x03FF;
  std::uint8_t multidrop = 0;
  bool operator==(const Route&) const = default;
};

struct RequestFrame {
  bool is_4e = false;
  std::uint16_t serial = 0;  ///< of a 4E frame
  Route route;
  std::uint16_t timer = 0;  ///< units of 250 ms; 0: without limit
  std::uint16_t command = 0;
  std::uint16_t subcommand = 0;
  Bytes payload;  ///< as on the wire: in ASCII its characters
};

enum class Found : std::uint8_t {
  request,
  part,     ///< the beginning of a request
  foreign,  ///< no request in this code: other subheader, other code, text that is not hex, length below its header
};

struct FoundRequest {
  Found found = Found::part;
  std::size_t size = 0;  ///< bytes of the whole request
  RequestFrame frame;
};

/// The request that the bytes begin with.
FoundRequest find_request(std::span<const std::uint8_t> bytes, Code code);

/// The whole reply; with an end code other than 0 the error information block takes the position of `data`, which is
/// in the form of the wire.
Bytes encode_reply(const RequestFrame& request, Code code, std::uint16_t end_code, const Bytes& data);

/// Offsets of a reply's fields, in bytes of the wire.
struct ReplyLayout {
  std::size_t unit;  ///< bytes on the wire for each byte of a field: 2 in ASCII
  std::size_t serial;
  std::size_t route;
  std::size_t length;
  std::size_t end_code;
  std::size_t data;
};
ReplyLayout reply_layout(bool is_4e, Code code);

}  // namespace symplant::test::slmp
