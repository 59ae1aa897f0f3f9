// A small plant and logs of runs that tests write by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "campaign/judge.hpp"
#include "support/described_plant.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::campaign {

inline constexpr tables::Time kMs = tables::kMillisecond;

/// Two inputs, a motor with two operations, a horn, two numbers, and a requirement.
inline const char* const kMembers = R"("alarms": ["L_P_HORN_O_ON", "L_P_CODE_O_FAULT"],
  "requirements": [{ "name": "never both", "never": "L_P_M_O_RUN and L_P_M_O_BACK" }])";

inline std::vector<test::Row> list() {
  std::vector<test::Row> rows = test::bits({"L_P_A_I_X", "L_P_B_I_X", "L_P_M_O_RUN", "L_P_M_O_BACK", "L_P_HORN_O_ON"});
  rows.push_back({"L_P_N_I_SPEED", "", "INT", "0", "%IW8"});
  rows.push_back({"L_P_CODE_O_FAULT", "", "INT", "0", "%QW8"});
  return rows;
}

struct Bench {
  explicit Bench(const std::string& members = kMembers) : plant(list(), members), names(plant.rows) {
    facts.alarms = plant.compiled().plant.alarms;
    base.stations = stations_of(plant.compiled().plant);
    for (std::uint32_t symbol = 0; symbol < plant.rows.symbols.size(); ++symbol) {
      base.operations.push_back(names.is_operation(symbol));
      if (names.is_operation(symbol)) base.symbol_of.emplace(names.symbol(symbol), symbol);
    }
    base.paced = base.operations;
    Reader reader{10 * kMs, base.operations, {0}};
    reader.events.flip();
    base.readers.push_back(reader);
  }

  /// A change of a symbol at a time in ms.
  struct Set {
    std::int64_t ms;
    const char* symbol;
    std::uint64_t value;
  };
  RunLog log(const std::vector<Set>& sets, std::int64_t end_ms = 5000) const {
    RunLog log;
    for (const Set& set : sets) log.symbols.push_back({set.ms * kMs, set.value, plant.symbol(set.symbol)});
    log.end = end_ms * kMs;
    return log;
  }
  void set_base(const std::vector<Set>& sets) {
    base.log = log(sets);
    base.recorded = recorded(base.log, names, base.operations, "base");
    base.pause = longest_pause(base.log, base.paced, base.log.end);
    for (const auto& [station, last] : last_changes(base.log, base)) base.pauses[station] = base.pause;
  }
  Result judged(const RunLog& run, const Fault& fault = {}) const {
    Result result;
    judge(base, facts, run, fault, result);
    return result;
  }
  Result judged(const std::vector<Set>& sets) const { return judged(log(sets)); }

  test::DescribedPlant plant;
  trace::PlantNames names;
  PlantFacts facts{names, {}};
  BaseCase base;
};

}  // namespace symplant::campaign
