// The device memory of a PLC, shared by the server, its scan program and a test.
#pragma once

#include <cstdint>
#include <mutex>
#include <string_view>
#include <vector>

#include "support/slmp/plc_devices.hpp"

namespace symplant::test::slmp {

/// Points `first` to `first + count - 1` of a device.
struct DeviceRange {
  std::string_view device;  ///< a name in device_types()
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool operator==(const DeviceRange&) const = default;
};

/// Every point is 0 at first. DX shares the memory of X, DY that of Y, and R that of ZR where a family has it.
/// Each call is atomic and takes about 20 ns. A call throws std::out_of_range if the CPU has no such point: in a test
/// that is an error.
class PlcMemory {
 public:
  /// With the family's usual number of points of each device.
  explicit PlcMemory(Family family = Family::iqr);

  /// Gives a device another size; its points become 0. A size of 0 removes the device.
  void configure(std::string_view device, std::uint32_t points);
  /// 0 if the CPU does not have the device.
  std::uint32_t points(std::string_view device) const;

  bool bit(std::string_view device, std::uint32_t number) const;
  void set_bit(std::string_view device, std::uint32_t number, bool on);
  /// The word of a bit device is its 16 points from `number` on, the first in bit 0.
  std::uint16_t word(std::string_view device, std::uint32_t number) const;
  void set_word(std::string_view device, std::uint32_t number, std::uint16_t value);
  /// Low word first; of a bit device 32 points.
  std::uint32_t dword(std::string_view device, std::uint32_t number) const;
  void set_dword(std::string_view device, std::uint32_t number, std::uint32_t value);

  // The server's part: devices by type, `count` words or bits at once, which must exist.
  std::uint32_t points(const DeviceType& device) const;
  void read_bits(const DeviceType& device, std::uint32_t first, std::uint32_t count, std::vector<std::uint32_t>&) const;
  void read_words(const DeviceType& device, std::uint32_t first, std::uint32_t count,
                  std::vector<std::uint32_t>&) const;
  void write_bits(const DeviceType& device, std::uint32_t first, const std::vector<std::uint32_t>& bits);
  void write_words(const DeviceType& device, std::uint32_t first, const std::vector<std::uint32_t>& words);

 private:
  using Area = std::vector<std::uint16_t>;  ///< of a bit device packed, point 0 in bit 0

  const DeviceType& existing(std::string_view device, std::uint32_t number, std::uint32_t units) const;
  std::size_t area_of(const DeviceType& device) const;
  bool get_bit(const DeviceType& device, std::uint32_t number) const;
  void put_bit(const DeviceType& device, std::uint32_t number, bool on);
  std::uint16_t get_word(const DeviceType& device, std::uint32_t number) const;
  void put_word(const DeviceType& device, std::uint32_t number, std::uint16_t value);
  void resize(const DeviceType& device);
  void write_sizes();
  void write_size(const DeviceType& sizes, std::uint32_t number, std::string_view device, bool is_dword);

  Family family_;
  mutable std::mutex mutex_;
  std::vector<std::uint32_t> points_;  ///< by index_of()
  std::vector<Area> areas_;            ///< by index_of()
};

}  // namespace symplant::test::slmp
