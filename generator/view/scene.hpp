// The input of every view: a plant, its tables, and the devices, tracks and places to show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/text_source.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::base {
class ProcessRunner;
}

namespace symplant::view {

struct Scene {
  const model::PlantModel& plant;
  const lower::EngineTables& tables;
  std::vector<std::uint32_t> units;         ///< the units to show, ascending
  std::vector<std::uint32_t> locations;     ///< the tracks and places to show, ascending, as in tables::MaterialTables
  base::ProcessRunner* programs = nullptr;  ///< null: no other program is run
};

/// A view as the text of a file, and the decisions made for it, for --verbose. The text is made when it is written; the
/// plant and the tables of the scene must exist until then.
struct View {
  base::TextSource text;
  std::vector<std::string> decisions = {};
};

}  // namespace symplant::view
