// Runs a plant with the operations of a recording.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "observe/play.hpp"
#include "recording/recording.hpp"
#include "study/start.hpp"

namespace symplant::study {

/// The run of a plant in virtual time from the state in which the recording begins, to its end. Operations, and events
/// that the plant does not drive, have the values of the recording at the times of the recording. An operation that was
/// not recorded stays as it is at the start of the plant; custom behaviors follow the rules of the model. The result
/// has the changes of all symbols, in the times of the recording; if the recording begins with a line of each symbol,
/// so does the result. O(the run).
recording::Recording run_with(const model::PlantModel& plant, const tables::PlantTables& tables,
                              const recording::Recording& recording, const observe::Matched& matched,
                              const Start& start, std::string name);

}  // namespace symplant::study
