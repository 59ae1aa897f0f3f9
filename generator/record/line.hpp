// What a recording has lines of, before it is written.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::record {

using tables::Time;

/// A change of a symbol, or a gap. Times are of the steady clock in ns.
struct Line {
  static constexpr std::uint32_t kGap = 0xFFFF'FFFF;

  Time time = 0;             ///< of a gap: when reading stopped
  std::uint64_t value = 0;   ///< as in the plant's value slots; of a gap: its length
  std::uint32_t symbol = 0;  ///< in PlantTables::symbols, or kGap
};

/// What one image has that the one before did not have.
struct Batch {
  std::vector<Line> lines;  ///< by time; no gaps. Symbols that were read for the first time are changes
  Time first = 0;           ///< the time of the image's first request
  Time last = 0;            ///< of its last request
  bool after_loss = false;  ///< images are missing before it: the connection was lost, or the queue was full
};

}  // namespace symplant::record
