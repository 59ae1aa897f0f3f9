// The text of bytes that are not a reply of the link's protocol, for messages.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace symplant::link::client {

/// "`HTTP/1.1 400 Bad Request`", the first line if it is printable; otherwise "the bytes 15 03 01 00", the first bytes.
std::string bytes_text(std::span<const std::uint8_t> bytes);

}  // namespace symplant::link::client
