// What reads what in the signal flow of a plant: values, signals, and conditions that compare values.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::model {

/// One thing that a reader reads. A reader has an entry for each thing, and may have several for one thing.
struct Read {
  enum class Reader : std::uint8_t {
    value,        ///< a formula or a jump
    signal,       ///< its formula
    follow,       ///< a symbol that follows a condition
    unit,         ///< conditions of its transitions, inputs of its custom behavior
    track,        ///< drives, stops and ends
    transfer,     ///< its condition
    work,         ///< its condition
    source,       ///< its condition
    requirement,  ///< its conditions
    malfunction,  ///< its conditions
  };
  enum class What : std::uint8_t {
    value,
    unit,
    symbol,
    location,  ///< parts at a track or place
    time,      ///< plant time
  };
  Reader reader{};
  std::uint32_t by = 0;  ///< the index of the reader in its list of PlantModel or Material
  What what{};
  std::uint32_t of = 0;  ///< the index of what is read
  /// What is read of it: a state, `moving`, `parts`, `weight`, a kind of parts; empty: all, or there is no choice.
  std::string_view part = {};
  bool in_condition = false;  ///< a condition tests it; else a formula or a speed is computed from it
};

/// The value of each output. O(outputs).
std::vector<std::uint32_t> values_of_outputs(const PlantModel& plant);

/// All that values, signals and conditions read, in the order of the plant. The texts belong to the plant.
/// O(formulas + conditions).
std::vector<Read> reads_of(const PlantModel& plant);

}  // namespace symplant::model
