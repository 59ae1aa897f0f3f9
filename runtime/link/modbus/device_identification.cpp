// Function 43/14 of Modbus, read device identification.
#include "symplant/link/modbus/device_identification.hpp"

#include <algorithm>
#include <array>

namespace symplant::link::modbus {

namespace {

constexpr std::uint8_t kReadDeviceIdentification = 14;
constexpr std::size_t kRequest = 4;
constexpr std::size_t kReplyHead = 7;

/// The codes of a request: 1 to 3 read the objects of a category, 4 reads one object.
constexpr std::uint8_t kBasic = 1;
constexpr std::uint8_t kOne = 4;
/// The conformity level of this server: the basic objects, as a stream and one by one.
constexpr std::uint8_t kConformity = 0x81;

constexpr std::size_t kObjects = 3;
static_assert(kReplyHead + kObjects * (2 + Identity::kMaxObject) <= kMaxPdu);

std::size_t put_object(std::size_t number, std::string_view text, std::span<std::uint8_t> reply) noexcept {
  const std::size_t size = std::min(text.size(), Identity::kMaxObject);
  reply[0] = static_cast<std::uint8_t>(number);
  reply[1] = static_cast<std::uint8_t>(size);
  std::transform(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size), reply.begin() + 2, [](char c) {
    return c >= ' ' && c <= '~' ? static_cast<std::uint8_t>(c) : static_cast<std::uint8_t>('?');
  });
  return 2 + size;
}

}  // namespace

Identified identify(std::span<const std::uint8_t> request, const Identity& identity,
                    std::span<std::uint8_t, kMaxPdu> reply) noexcept {
  if (request.size() >= 2 && request[1] != kReadDeviceIdentification) {
    return {.exception = Exception::illegal_function};
  }
  if (request.size() != kRequest) return {.exception = Exception::illegal_data_value};
  const std::uint8_t code = request[2];
  if (code < kBasic || code > kOne) return {.exception = Exception::illegal_data_value};
  const std::array<std::string_view, kObjects> objects = {identity.vendor, identity.product, identity.revision};
  std::size_t first = request[3];
  if (first >= kObjects) {
    if (code == kOne) return {.exception = Exception::illegal_data_address};
    first = 0;  // a stream from an unknown object begins at the first one
  }
  const std::size_t end = code == kOne ? first + 1 : kObjects;
  std::copy_n(request.begin(), 3, reply.begin());
  reply[3] = kConformity;
  reply[4] = 0;  // no more follows: all objects fit into one reply
  reply[5] = 0;
  reply[6] = static_cast<std::uint8_t>(end - first);
  std::size_t size = kReplyHead;
  for (std::size_t number = first; number < end; ++number) {
    size += put_object(number, objects[number], reply.subspan(size));
  }
  return {.size = size};
}

}  // namespace symplant::link::modbus
