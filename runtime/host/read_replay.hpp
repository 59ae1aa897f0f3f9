// Reads from a trace what a replay needs.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "symplant/scenario/scenario.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// What came to the plant from outside in a recorded run, in its order.
struct Replay {
  struct Deed {
    enum class Kind : std::uint8_t {
      operation,  ///< symbol `of` has the value `value` from this instant on
      act,        ///< step `of` of `acts`
      quality,    ///< the link of behavior `of` (PlantTables::behaviour_units) is connected if `value` is 1
    };
    tables::Time time;
    std::uint64_t instant;  ///< among those of this time, from 1
    std::uint64_t value;
    std::uint32_t of;
    Kind kind;
  };
  std::vector<Deed> deeds;
  scenario::Scenario acts;         ///< a step for each act; the times of the steps have no meaning
  std::vector<std::string> texts;  ///< of each act, as the trace has it
  std::vector<bool> by_hand;       ///< whether an act was done by hand, else by a scenario
  std::string model_hash;          ///< of the header
  std::uint64_t seed = 0;          ///< of the header
  tables::Time end = 0;            ///< the time of the last line
};

/// Nothing, with messages on `err`, if the file cannot be read or replayed. O(file).
std::optional<Replay> load_replay(const std::string& path, const trace::PlantNames& names, std::ostream& err);

/// `replay t.jsonl: 4 changes of operations, 1 act`.
std::string replay_summary(const std::string& path, const Replay& replay);

}  // namespace symplant::host
