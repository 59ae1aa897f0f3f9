// Pairs of plants whose names say nothing.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "learn/pairs.hpp"
#include "support/compile.hpp"

namespace symplant::test {

/// Operations and events that no naming rule reads.
inline Analysed unnamed_plant(const std::vector<std::string>& operations, const std::vector<std::string>& events) {
  std::vector<Row> rows;
  for (const std::string& name : operations) {
    rows.push_back({name, "", "BOOL", "FALSE", "%QX" + std::to_string(rows.size())});
  }
  for (const std::string& name : events) {
    rows.push_back({name, "", "BOOL", "FALSE", "%IX" + std::to_string(rows.size())});
  }
  return analyse_rows(rows);
}

inline learn::Input input_of(const model::PlantModel& plant, recording::Recording recording) {
  observe::Matched matched = observe::match(plant, recording);
  return {std::move(recording), std::move(matched)};
}

}  // namespace symplant::test
