// A device request: its payload decoded and checked for everything that does not depend on the memory (section 1.6).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/slmp/plc_frames.hpp"
#include "support/slmp/plc_profile.hpp"

namespace symplant::test::slmp {

enum Command : std::uint16_t {
  kReadModel = 0x0101,
  kRead = 0x0401,
  kReadRandom = 0x0403,
  kReadBlocks = 0x0406,
  kLoopback = 0x0619,
  kWrite = 0x1401,
  kWriteRandom = 0x1402,
  kWriteBlocks = 0x1406,
};

/// One device specification of a request, with what belongs to it.
struct Item {
  const DeviceType* device = nullptr;  ///< null: unknown
  std::uint32_t number = 0;
  std::uint32_t points = 1;
  std::uint32_t width = 16;           ///< bits of a point: 1, 16 or 32
  std::vector<std::uint32_t> values;  ///< of a write: one for each point

  /// Points of the device itself that the item covers: 16 for each word of a bit device.
  std::uint32_t covered() const { return device->is_bit ? points * width : points * (width == 32 ? 2 : 1); }
};

struct DeviceRequest {
  std::uint16_t command = 0;
  bool is_write = false;
  std::uint32_t points = 0;  ///< as the limits count them
  std::vector<Item> items;   ///< words before dwords, word blocks before bit blocks
  std::string text;          ///< of a loopback
};

struct DecodedRequest {
  std::uint16_t end_code = kOk;
  DeviceRequest request;
};

/// The end code is that of the first broken rule in this order: command, subcommand, number of points, length, text
/// that is not hex, device, kind of device, value of a bit. `has_octal_input_output`: X and Y are octal in ASCII.
DecodedRequest decode(const RequestFrame& frame, const PlcProfile& profile, Code code,
                      bool has_octal_input_output = false);

}  // namespace symplant::test::slmp
