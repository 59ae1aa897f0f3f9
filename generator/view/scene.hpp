// What every view is given: a plant, its tables, and which of its devices are to be seen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::base {
class ProcessRunner;
}

namespace symplant::view {

struct Scene {
  const model::PlantModel& plant;
  const lower::EngineTables& tables;
  std::vector<std::uint32_t> units;         ///< those to be seen, ascending
  base::ProcessRunner* programs = nullptr;  ///< null: no other program is asked for help
};

/// A view as a file's text, and what was decided on the way, for --verbose.
struct View {
  std::string text;
  std::vector<std::string> decisions = {};
};

}  // namespace symplant::view
