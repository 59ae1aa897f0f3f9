// What a family of PLCs can do over SLMP: frames, commands, limits, end codes (sections 1.0, 1.8 and 1.9).
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/slmp/plc_devices.hpp"

namespace symplant::test::slmp {

/// End codes that do not depend on the family.
enum EndCode : std::uint16_t {
  kOk = 0x0000,
  kNotInRun = 0x0055,
  kReadOnly = 0x4030,
  kNumberOutOfRange = 0x4031,
  kDeviceNotInThisCommand = 0x4032,
  kE71RandomPoints = 0x4080,
  kNotHex = 0xC050,
  kPoints1 = 0xC051,
  kPoints2 = 0xC052,
  kRandomBits = 0xC053,
  kRandomWords = 0xC054,
  kBeyondLastDevice = 0xC056,
  kCommand = 0xC059,
  kDevice = 0xC05B,
  kContent = 0xC05C,
  kOtherTarget = 0xC05F,
  kBitValue = 0xC060,
  kLength = 0xC061,
};

/// The most that one request may hold.
struct Limits {
  std::uint32_t words;
  std::uint32_t bits;
  std::uint32_t random_read;        ///< words and dwords together
  std::uint32_t random_write_cost;  ///< 12 for each word, 14 for each dword
  std::uint32_t random_bits;
  std::uint32_t blocks;
  std::uint32_t block_points;
  std::uint32_t block_write_overhead;  ///< points that each block of 1406 counts more
};

/// The port of the CPU itself, or a QJ71E71 or LJ71E71 module.
enum class Port : std::uint8_t { built_in, e71 };

struct PlcProfile {
  Family family;
  Port port;
  bool has_4e;               ///< if not, a 4E request gets no reply
  bool has_iqr_subcommands;  ///< if not, 0002 and 0003 get `foreign_subcommand`
  bool has_model;            ///< 0101
  bool has_blocks;           ///< 0406, 1406
  bool has_bit_batches;      ///< 1401 in units of bits; a report doubts it for GX Simulator3
  bool has_loopback;         ///< 0619
  bool writes_steps;         ///< writes to S; if not, 4030
  std::uint16_t foreign_subcommand;
  std::uint16_t too_many_words;
  std::uint16_t too_many_bits;
  std::uint16_t too_many_random_words;
  std::uint16_t out_of_range;

  Limits limits(bool with_iqr_subcommand, Code code) const;
};

/// Where the reference has no measured value: total points and blocks out of range in 0406 and 1406 answer as too many
/// words; 1406 of FX5 has the overhead of Q/L.
PlcProfile profile_of(Family family, Port port = Port::built_in);

}  // namespace symplant::test::slmp
