// Classes a run with a fault.
#pragma once

#include <vector>

#include "campaign/base_case.hpp"
#include "campaign/fault.hpp"
#include "campaign/result.hpp"
#include "elements/alarm/model.hpp"

namespace symplant::campaign {

/// What the program reads first that differs from the base case.
struct Seen {
  tables::Time time = 0;
  std::uint32_t symbol = tables::kNone;  ///< kNone: its controller is lost, so it reads nothing
  std::uint64_t value = 0;
};

/// The first scan that reads something else than in the base case, or the first difference if a PLC may read at any
/// time; nothing if all it reads is the same. O(changes).
std::optional<Seen> first_seen(const BaseCase& base, const RunLog& log, const trace::PlantNames& names);

/// What is known of the plant besides its tables.
struct PlantFacts {
  const trace::PlantNames& names;  ///< with the malfunctions of the campaign
  std::vector<model::Alarm> alarms;
};

/// Fills the class of a result and all that follows from the run. `goes_on`: when the next operation changes after the
/// run, if a longer one has shown that; nothing: it is not known. O(changes of both runs).
void judge(const BaseCase& base, const PlantFacts& plant, const RunLog& log, const Fault& fault, Result& result,
           std::optional<tables::Time> goes_on = {});

}  // namespace symplant::campaign
