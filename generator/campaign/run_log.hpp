// What a run did, as far as a campaign compares it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "recording/of_run.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::campaign {

using Change = recording::RunChange;
using recording::number_of;

struct Violation {
  tables::Time time;
  std::uint32_t requirement;
};

/// The changes of a run, by time.
struct RunLog {
  std::vector<Change> symbols;
  std::vector<Change> outputs;              ///< of values, where traces show them
  std::vector<Change> units;                ///< trace::pack_unit()
  std::vector<Change> malfunctions;         ///< `value` is 1 if one starts, 0 if it ends
  std::optional<Violation> violation = {};  ///< the first one
  tables::Time end = 0;

  void take(const trace::Record& record);
};

/// The changes of the symbols that are chosen, for comparisons. O(symbols + changes).
recording::Recording recorded(const RunLog& log, const trace::PlantNames& names, const std::vector<bool>& chosen,
                              const char* name);

}  // namespace symplant::campaign
