// Which symbols of a plant a recording has.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "recording/recording.hpp"

namespace symplant::observe {

/// Which symbol of a plant each series of a recording is.
struct Matched {
  struct Unknown {
    std::string name;
    std::string nearest;  ///< a symbol with a similar name that the recording does not have; empty: none
  };
  std::vector<std::uint32_t> symbols;  ///< by series; kNone: no symbol of the plant, or parts
  std::vector<bool> recorded;          ///< by symbol of the plant
  std::vector<Unknown> unknown;        ///< series that are no symbol, by name

  /// Whether any series is a symbol. O(series).
  bool has_symbols() const;
};

/// "`CLAMP_O_CLOS` (did you mean `CLAMP_O_CLOSE`?)".
std::string words_of(const Matched::Unknown& unknown);

/// A series has the name of its symbol, or its address. Names count more: of two series of one symbol, the one with the
/// address is unknown. O(series + symbols, and unknown series * symbols for the nearest names of the first 20).
Matched match(const model::PlantModel& plant, const recording::Recording& recording);

/// The same, and gives the series of symbols the names, types and directions that they have in the plant: a column of 0
/// and 1 may be BOOL or a number, and names need not have a direction. O(changes), too.
Matched adopt(const model::PlantModel& plant, recording::Recording& recording);

}  // namespace symplant::observe
