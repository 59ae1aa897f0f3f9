// Runs a plant with a random program and records it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"
#include "property/recordings/random_commands.hpp"
#include "property/recordings/true_moves.hpp"
#include "recording/recording.hpp"

namespace symplant::property {

struct RunOptions {
  std::uint64_t seed = 1;  ///< of the program and of random times
  Commands commands = Commands::closed_loop;
  tables::Time length = 600 * tables::kSecond;
  tables::Time every = 0;  ///< the interval of reading; 0: every change with its exact time
};

struct RecordedRun {
  recording::Recording recording;
  std::vector<TrueMove> moves;
};

/// Runs a plant in virtual time, with a scan of its program every 10 ms. Readings have their own phase, which is not
/// that of the scans. O(length / 10 ms, and changes).
RecordedRun record_run(const model::PlantModel& plant, const RunOptions& options);

}  // namespace symplant::property
