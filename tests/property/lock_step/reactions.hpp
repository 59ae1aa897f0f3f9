// Random programs: tables of reactions, and what a scan does with them, for engine and reference.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "property/dice.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::property {

/// What a scan makes of one operation.
struct Reaction {
  enum class Kind : std::uint8_t { copy, invert, both, toggle, on_delay, pulse, keep, add, clock };
  static constexpr std::size_t kKinds = 9;
  Kind kind = Kind::copy;
  std::size_t a = 0;  ///< indexes of variables that are read
  std::size_t b = 0;
  std::uint32_t scans = 1;
};

struct ProgramTable {
  std::string name;
  std::uint32_t controller = 0;
  tables::Time period = 0;
  tables::Time delay = 0;
  bool zero_on_loss = false;
  std::vector<std::uint32_t> reads;  ///< symbols
  std::vector<std::uint32_t> writes;
  std::vector<Reaction> reactions;  ///< by write
};

/// What a program remembers from scan to scan.
struct ProgramMemory {
  std::vector<std::uint64_t> before;  ///< by read: in the previous scan
  std::vector<std::uint32_t> counts;  ///< by write
  explicit ProgramMemory(const ProgramTable& table) : before(table.reads.size()), counts(table.writes.size()) {}
};

/// One scan. `in` are the numbers that are read, `out` those that are written, which keep their values otherwise.
void react(const ProgramTable& table, ProgramMemory& memory, const std::vector<std::uint64_t>& in,
           std::vector<std::uint64_t>& out, tables::Time now);

/// One to three programs that write different operations. Fewer than two symbols: none.
std::vector<ProgramTable> random_programs(Dice& dice, const model::PlantModel& model,
                                          const tables::PlantTables& tables);

/// Bits of a symbol's type: 1 of BOOL.
unsigned bits_of(tables::DataType type);

}  // namespace symplant::property
