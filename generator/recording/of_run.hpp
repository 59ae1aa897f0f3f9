// The records of a run as a recording.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::recording {

/// A change of a symbol, an output of a value, or a device.
struct RunChange {
  tables::Time time;
  std::uint64_t value;  ///< as trace::Record has it
  std::uint32_t of;
};

/// The number in a symbol's slot; of a BOOL symbol 0 or 1.
double number_of(const tables::SymbolRow& symbol, std::uint64_t value);

/// The changes of the symbols that are chosen, in virtual time. `changes` are those of symbols, by time.
/// O(symbols + changes).
Recording of_run(std::span<const RunChange> changes, tables::Time end, const trace::PlantNames& names,
                 const std::vector<bool>& chosen, std::string name);

}  // namespace symplant::recording
