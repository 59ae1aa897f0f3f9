// How accurately a plant repeats a recording: the run of the plant with the recorded operations, and each movement.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/play.hpp"
#include "recording/recording.hpp"
#include "study/movement.hpp"

namespace symplant::study {

/// Movements of one name.
struct Row {
  std::string name;
  std::size_t count = 0;
  double least = 1;
  double greatest = 0;
  double mean = 0;  ///< weighted by the durations
};

struct Study {
  recording::Recording run;  ///< `run of PLANT`
  tables::Time resolution = 0;
  tables::Time begin = 0;
  std::size_t states = 0;              ///< devices that the run begins in another state than that of the model
  std::size_t numbers = 0;             ///< values that begin with the recorded number
  std::size_t unknown = 0;             ///< devices whose recorded events show no state at the beginning
  std::vector<std::string> unmatched;  ///< of names of the recording that are no symbols, with the nearest one
  std::vector<Movement> movements;     ///< by their ends
  std::vector<Row> rows;               ///< by name
  Row total;
};

/// The rows of movements, by name, and the row of all. O(movements * log(movements)).
std::vector<Row> rows_of(const std::vector<Movement>& movements);
Row total_of(const std::vector<Movement>& movements);

/// Runs a plant with the operations of a recording and compares the movements. `chosen`: whether a symbol is compared;
/// a device is if one of its events is. O(the run).
Study study(const model::PlantModel& plant, const tables::PlantTables& tables, const recording::Recording& recording,
            const std::string& plant_file, const std::function<bool(std::string_view)>& chosen);

}  // namespace symplant::study
