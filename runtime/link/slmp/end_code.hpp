// End codes of SLMP in plain words.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "symplant/link/slmp/framing.hpp"

namespace symplant::link::slmp {

/// What an end code asks for.
enum class Remedy : std::uint8_t {
  configure,  ///< the request does not succeed before map, family or parameters change
  permit,     ///< the PLC does not allow it now
  try_again,  ///< busy, or a relay failed: the same request may succeed soon
};

struct EndCode {
  std::uint16_t code;
  Remedy remedy;
  const char* meaning;  ///< "the number of points is out of range"
  const char* action;   ///< what to do: "map the symbol to another device"
};

/// All rows, ascending.
std::span<const EndCode> end_codes() noexcept;

/// The row of a code; of an unknown one a row with its range in general words. O(log rows).
const EndCode& end_code_of(std::uint16_t code) noexcept;

/// "end code C056 (the last device is beyond the configured range): give ..."; the meaning, and what to do on a link
/// with this framing.
std::string end_code_text(std::uint16_t code, const Framing& framing);

}  // namespace symplant::link::slmp
