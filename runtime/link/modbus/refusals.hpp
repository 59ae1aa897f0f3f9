// The kinds of requests that a server has answered with an exception.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "symplant/link/modbus/fields.hpp"
#include "symplant/link/modbus/pdu.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link::modbus {

/// "function 15 (write coils) from number 800 on with exception 02: ...": what the server answered with an exception,
/// what that means and what to do. The side is modbus_server.
std::string answer_text(const tables::Refusal& refusal);

/// A kind is a function, an exception and a first address. O(kKinds).
class Refusals {
 public:
  /// The number of kinds that are kept. Any further kind does not count as new.
  static constexpr std::size_t kKinds = 16;

  /// The refusal of a request, not empty, if it is the first of its kind.
  std::optional<tables::Refusal> add(std::span<const std::uint8_t> request, Exception exception) noexcept {
    const tables::Refusal refusal{tables::Refusal::Side::modbus_server, request[0],
                                  static_cast<std::uint16_t>(exception), address_of(request)};
    const auto end = kinds_.begin() + size_;
    if (size_ == kKinds || std::find(kinds_.begin(), end, refusal) != end) return std::nullopt;
    kinds_[size_++] = refusal;
    return refusal;
  }

 private:
  /// 0 of functions whose data do not begin with an address.
  static std::uint32_t address_of(std::span<const std::uint8_t> request) noexcept {
    constexpr std::array<std::uint8_t, 10> kWithAddress = {1, 2, 3, 4, 5, 6, 15, 16, 22, 23};
    const bool has = std::find(kWithAddress.begin(), kWithAddress.end(), request[0]) != kWithAddress.end();
    return has && request.size() >= 3 ? field(request, 1) : 0;
  }

  std::array<tables::Refusal, kKinds> kinds_{};
  std::uint8_t size_ = 0;
};

}  // namespace symplant::link::modbus
