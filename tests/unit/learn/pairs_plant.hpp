// Random plants whose names say nothing, and recordings of their sequences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "recording/recording.hpp"

namespace symplant::test {

/// What is random in a plant and its program.
struct PlantProfile {
  std::size_t least_devices = 20;
  std::size_t most_devices = 60;
  std::size_t most_stations = 3;  ///< sequences that run at the same time, each with its own cycle
  std::size_t cycles = 20;
  bool fixed_sequence = true;     ///< else each cycle moves the devices in another order
  double forks = 0.3;             ///< the share of steps that begin two moves in one scan
  double always_together = 0.05;  ///< the share of moves that begin with another one in each cycle, in both directions
  double jitter = 0.1;            ///< of travel times, to both sides
  double resolution = 0.05;       ///< of the recording, in s
};

/// A recording of a plant, and what drives what.
struct PairsPlant {
  std::vector<std::string> operations;
  std::vector<std::string> events;
  std::set<std::tuple<std::string, std::string, bool>> pairs;  ///< operation, event, inverted
  recording::Recording recording;
};

PairsPlant random_pairs_plant(std::uint64_t seed, const PlantProfile& profile);

}  // namespace symplant::test
