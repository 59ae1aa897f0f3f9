// Bytes that no protocol of the link explains, for messages.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace symplant::link::client {

/// "`HTTP/1.1 400 Bad Request`", the first line of what is printable; otherwise "the bytes 15 03 01 00", the first
/// ones.
std::string bytes_text(std::span<const std::uint8_t> bytes);

}  // namespace symplant::link::client
