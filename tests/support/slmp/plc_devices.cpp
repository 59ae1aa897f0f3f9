// The table of the devices. Sizes are like those of a Q06UDV, L16H, R08 and FX5U.
#include "support/slmp/plc_devices.hpp"

#include <algorithm>

namespace symplant::test::slmp {
namespace {

using Sizes = std::array<std::uint32_t, 4>;

constexpr auto kDec = NumberBase::decimal;
constexpr auto kHex = NumberBase::hex;
constexpr auto kIo = NumberBase::input_output;
constexpr Sizes kTimers = {2048, 2048, 1024, 512};
constexpr Sizes kRetentive = {1024, 1024, 1024, 16};
constexpr Sizes kCounters = {1024, 1024, 512, 256};

constexpr std::array kDevices = {
    DeviceType{"SM", "SM", 0x91, true, kDec, {2048, 2048, 4096, 10'000}, ""},
    DeviceType{"SD", "SD", 0xA9, false, kDec, {2048, 2048, 4096, 12'000}, ""},
    DeviceType{"X", "X", 0x9C, true, kIo, {8192, 8192, 8192, 1024}, ""},
    DeviceType{"Y", "Y", 0x9D, true, kIo, {8192, 8192, 8192, 1024}, ""},
    DeviceType{"M", "M", 0x90, true, kDec, {8192, 8192, 8192, 7680}, ""},
    DeviceType{"L", "L", 0x92, true, kDec, {8192, 8192, 8192, 7680}, ""},
    DeviceType{"F", "F", 0x93, true, kDec, {2048, 2048, 2048, 128}, ""},
    DeviceType{"V", "V", 0x94, true, kDec, {2048, 2048, 2048, 0}, ""},
    DeviceType{"B", "B", 0xA0, true, kHex, {8192, 8192, 8192, 256}, ""},
    DeviceType{"D", "D", 0xA8, false, kDec, {12'288, 12'288, 12'288, 8000}, ""},
    DeviceType{"W", "W", 0xB4, false, kHex, {8192, 8192, 8192, 512}, ""},
    DeviceType{"TS", "TS", 0xC1, true, kDec, kTimers, ""},
    DeviceType{"TC", "TC", 0xC0, true, kDec, kTimers, ""},
    DeviceType{"TN", "TN", 0xC2, false, kDec, kTimers, ""},
    DeviceType{"STS", "SS", 0xC7, true, kDec, kRetentive, ""},
    DeviceType{"STC", "SC", 0xC6, true, kDec, kRetentive, ""},
    DeviceType{"STN", "SN", 0xC8, false, kDec, kRetentive, ""},
    DeviceType{"CS", "CS", 0xC4, true, kDec, kCounters, ""},
    DeviceType{"CC", "CC", 0xC3, true, kDec, kCounters, ""},
    DeviceType{"CN", "CN", 0xC5, false, kDec, kCounters, ""},
    DeviceType{"SB", "SB", 0xA1, true, kHex, {2048, 2048, 2048, 512}, ""},
    DeviceType{"SW", "SW", 0xB5, false, kHex, {2048, 2048, 2048, 512}, ""},
    DeviceType{"DX", "DX", 0xA2, true, kHex, {8192, 8192, 8192, 0}, "X"},
    DeviceType{"DY", "DY", 0xA3, true, kHex, {8192, 8192, 8192, 0}, "Y"},
    DeviceType{"S", "S", 0x98, true, kDec, {8192, 8192, 8192, 4096}, ""},
    DeviceType{"Z", "Z", 0xCC, false, kDec, {20, 20, 20, 20}, ""},
    DeviceType{"ZR", "ZR", 0xB0, false, kDec, {32'768, 32'768, 32'768, 0}, ""},
    DeviceType{"R", "R", 0xAF, false, kDec, {32'768, 32'768, 32'768, 32'768}, "ZR"},
    DeviceType{"RD", "", 0x2C, false, kDec, {0, 0, 4096, 0}, ""},
};

template <class Predicate>
const DeviceType* device_with(const Predicate& predicate) {
  const auto* const at = std::find_if(kDevices.begin(), kDevices.end(), predicate);
  return at == kDevices.end() ? nullptr : at;
}

}  // namespace

std::span<const DeviceType> device_types() { return kDevices; }

const DeviceType* device_of_name(std::string_view name) {
  return device_with([&](const DeviceType& device) { return device.name == name; });
}

const DeviceType* device_of_code(std::uint16_t code) {
  return device_with([&](const DeviceType& device) { return device.code == code; });
}

const DeviceType* device_of_padded_name(std::string_view name) {
  const std::string_view bare = name.substr(0, name.find('*'));
  if (bare.empty() || name.find_first_not_of('*', bare.size()) != name.npos) return nullptr;
  const bool is_ql = name.size() == 2;
  return device_with([&](const DeviceType& device) { return (is_ql ? device.ql_name : device.name) == bare; });
}

std::size_t index_of(const DeviceType& device) { return static_cast<std::size_t>(&device - kDevices.data()); }

unsigned base_of(const DeviceType& device, Family family) {
  if (device.base == kDec) return 10;
  return device.base == kIo && family == Family::fx5 ? 8 : 16;
}

std::string address_text(const DeviceType& device, std::uint32_t number, Family family) {
  const unsigned base = base_of(device, family);
  std::string digits;
  do {
    digits.insert(digits.begin(), "0123456789ABCDEF"[number % base]);
    number /= base;
  } while (number != 0);
  return std::string(device.name) + digits;
}

}  // namespace symplant::test::slmp
