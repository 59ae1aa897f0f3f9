// The device memory of a PLC.
#include "support/slmp/plc_memory.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kWordBits = 16;

/// A special register that holds the configured number of points of a device (section 1.12).
struct SizeRegister {
  std::uint32_t number;
  std::string_view device;
  bool is_dword;
};

constexpr std::array kSizesOfQ = {
    SizeRegister{286, "M", true},   SizeRegister{288, "B", true},    SizeRegister{290, "X", false},
    SizeRegister{291, "Y", false},  SizeRegister{293, "L", false},   SizeRegister{295, "F", false},
    SizeRegister{296, "SB", false}, SizeRegister{297, "V", false},   SizeRegister{298, "S", false},
    SizeRegister{299, "TN", false}, SizeRegister{300, "STN", false}, SizeRegister{301, "CN", false},
    SizeRegister{304, "SW", false}, SizeRegister{306, "ZR", true},   SizeRegister{308, "D", true},
    SizeRegister{310, "W", true},
};
constexpr std::array kSizesOfR = {
    SizeRegister{260, "X", true},  SizeRegister{262, "Y", true},   SizeRegister{264, "M", true},
    SizeRegister{266, "B", true},  SizeRegister{268, "SB", true},  SizeRegister{270, "F", true},
    SizeRegister{272, "V", true},  SizeRegister{274, "L", true},   SizeRegister{276, "S", true},
    SizeRegister{280, "D", true},  SizeRegister{282, "W", true},   SizeRegister{284, "SW", true},
    SizeRegister{288, "TN", true}, SizeRegister{290, "STN", true}, SizeRegister{292, "CN", true},
    SizeRegister{300, "Z", true},  SizeRegister{306, "ZR", true},  SizeRegister{308, "RD", true},
};

}  // namespace

PlcMemory::PlcMemory(Family family) : family_(family), points_(device_types().size()), areas_(device_types().size()) {
  for (const DeviceType& device : device_types()) {
    points_[index_of(device)] = device.points[static_cast<std::size_t>(family)];
  }
  for (const DeviceType& device : device_types()) resize(device);
  write_sizes();
}

void PlcMemory::configure(std::string_view device, std::uint32_t points) {
  const std::lock_guard lock(mutex_);
  const DeviceType* const type = device_of_name(device);
  if (type == nullptr) throw std::out_of_range("no device `" + std::string(device) + "`");
  points_[index_of(*type)] = points;
  areas_[area_of(*type)].clear();
  for (const DeviceType& each : device_types()) resize(each);
  write_sizes();
}

/// Devices that share an area need the larger of their sizes.
void PlcMemory::resize(const DeviceType& device) {
  const std::uint32_t points = points_[index_of(device)];
  Area& words = areas_[area_of(device)];
  const std::size_t needed = device.is_bit ? (points + kWordBits - 1) / kWordBits + 1 : points;
  words.resize(std::max(words.size(), needed));
}

void PlcMemory::write_sizes() {
  const DeviceType& special = *device_of_name("SD");
  if (family_ == Family::q || family_ == Family::l) {
    for (const SizeRegister& each : kSizesOfQ) write_size(special, each.number, each.device, each.is_dword);
    return;
  }
  for (const SizeRegister& each : kSizesOfR) write_size(special, each.number, each.device, each.is_dword);
  if (family_ == Family::fx5) write_size(special, 304, "R", true);
}

void PlcMemory::write_size(const DeviceType& sizes, std::uint32_t number, std::string_view device, bool is_dword) {
  const std::uint32_t points = points_[index_of(*device_of_name(device))];
  if (number + 1 >= points_[index_of(sizes)]) return;
  put_word(sizes, number, static_cast<std::uint16_t>(is_dword ? points : std::min(points, 0xFFFFU)));
  if (is_dword) put_word(sizes, number + 1, static_cast<std::uint16_t>(points >> kWordBits));
}

std::uint32_t PlcMemory::points(const DeviceType& device) const {
  const std::lock_guard lock(mutex_);
  return points_[index_of(device)];
}

std::uint32_t PlcMemory::points(std::string_view device) const {
  const DeviceType* const type = device_of_name(device);
  return type == nullptr ? 0 : points(*type);
}

/// The device, if it has `units` points from `number` on.
const DeviceType& PlcMemory::existing(std::string_view device, std::uint32_t number, std::uint32_t units) const {
  const DeviceType* const type = device_of_name(device);
  if (type == nullptr) throw std::out_of_range("no device `" + std::string(device) + "`");
  if (std::uint64_t{number} + units > points_[index_of(*type)]) {
    throw std::out_of_range("no point " + address_text(*type, number, family_));
  }
  return *type;
}

std::size_t PlcMemory::area_of(const DeviceType& device) const {
  const DeviceType* const owner = device.shares.empty() ? nullptr : device_of_name(device.shares);
  return index_of(owner != nullptr && points_[index_of(*owner)] > 0 ? *owner : device);
}

bool PlcMemory::get_bit(const DeviceType& device, std::uint32_t number) const {
  return (areas_[area_of(device)][number / kWordBits] >> (number % kWordBits) & 1U) != 0;
}

void PlcMemory::put_bit(const DeviceType& device, std::uint32_t number, bool on) {
  std::uint16_t& word = areas_[area_of(device)][number / kWordBits];
  const auto mask = static_cast<std::uint16_t>(1U << (number % kWordBits));
  word = static_cast<std::uint16_t>(on ? word | mask : word & ~mask);
}

std::uint16_t PlcMemory::get_word(const DeviceType& device, std::uint32_t number) const {
  const Area& words = areas_[area_of(device)];
  if (!device.is_bit) return words[number];
  const std::uint32_t pair = words[number / kWordBits] | std::uint32_t{words[number / kWordBits + 1]} << kWordBits;
  return static_cast<std::uint16_t>(pair >> (number % kWordBits));
}

void PlcMemory::put_word(const DeviceType& device, std::uint32_t number, std::uint16_t value) {
  if (!device.is_bit) {
    areas_[area_of(device)][number] = value;
    return;
  }
  for (std::uint32_t bit = 0; bit < kWordBits; ++bit) put_bit(device, number + bit, (value >> bit & 1U) != 0);
}

bool PlcMemory::bit(std::string_view device, std::uint32_t number) const {
  const std::lock_guard lock(mutex_);
  return get_bit(existing(device, number, 1), number);
}

void PlcMemory::set_bit(std::string_view device, std::uint32_t number, bool on) {
  const std::lock_guard lock(mutex_);
  put_bit(existing(device, number, 1), number, on);
}

std::uint16_t PlcMemory::word(std::string_view device, std::uint32_t number) const {
  const std::lock_guard lock(mutex_);
  const DeviceType* const type = device_of_name(device);
  return get_word(existing(device, number, type != nullptr && type->is_bit ? kWordBits : 1), number);
}

void PlcMemory::set_word(std::string_view device, std::uint32_t number, std::uint16_t value) {
  const std::lock_guard lock(mutex_);
  const DeviceType* const type = device_of_name(device);
  put_word(existing(device, number, type != nullptr && type->is_bit ? kWordBits : 1), number, value);
}

std::uint32_t PlcMemory::dword(std::string_view device, std::uint32_t number) const {
  const std::lock_guard lock(mutex_);
  const DeviceType* const type = device_of_name(device);
  const std::uint32_t step = type != nullptr && type->is_bit ? kWordBits : 1;
  const DeviceType& known = existing(device, number, 2 * step);
  return get_word(known, number) | std::uint32_t{get_word(known, number + step)} << kWordBits;
}

void PlcMemory::set_dword(std::string_view device, std::uint32_t number, std::uint32_t value) {
  const std::lock_guard lock(mutex_);
  const DeviceType* const type = device_of_name(device);
  const std::uint32_t step = type != nullptr && type->is_bit ? kWordBits : 1;
  const DeviceType& known = existing(device, number, 2 * step);
  put_word(known, number, static_cast<std::uint16_t>(value));
  put_word(known, number + step, static_cast<std::uint16_t>(value >> kWordBits));
}

void PlcMemory::read_bits(const DeviceType& device, std::uint32_t first, std::uint32_t count,
                          std::vector<std::uint32_t>& bits) const {
  const std::lock_guard lock(mutex_);
  for (std::uint32_t i = 0; i < count; ++i) bits.push_back(get_bit(device, first + i) ? 1 : 0);
}

void PlcMemory::read_words(const DeviceType& device, std::uint32_t first, std::uint32_t count,
                           std::vector<std::uint32_t>& words) const {
  const std::lock_guard lock(mutex_);
  const std::uint32_t step = device.is_bit ? kWordBits : 1;
  for (std::uint32_t i = 0; i < count; ++i) words.push_back(get_word(device, first + i * step));
}

void PlcMemory::write_bits(const DeviceType& device, std::uint32_t first, const std::vector<std::uint32_t>& bits) {
  const std::lock_guard lock(mutex_);
  for (const std::uint32_t bit : bits) put_bit(device, first++, bit != 0);
}

void PlcMemory::write_words(const DeviceType& device, std::uint32_t first, const std::vector<std::uint32_t>& words) {
  const std::lock_guard lock(mutex_);
  for (const std::uint32_t word : words) {
    put_word(device, first, static_cast<std::uint16_t>(word));
    first += device.is_bit ? kWordBits : 1;
  }
}

}  // namespace symplant::test::slmp
