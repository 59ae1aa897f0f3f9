// A plant description to begin with: what was inferred as comments, what could be said as keys that are commented out.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// What the description has to say of the list so that it is read as it was.
struct SkeletonList {
  std::string file;      ///< relative to the description
  std::string format;    ///< empty: sniffed
  std::string encoding;  ///< empty: sniffed
  std::string xy;        ///< `hex`, `octal`; empty: not said
};

/// The text of a plant.json: valid as it stands, and the same plant as the bare list. Each line that is a key behind
/// `//` may be uncommented, alone or together with others, and it stays valid. One entry a shape of devices.
std::string skeleton(const model::PlantModel& plant, const SkeletonList& list);

}  // namespace symplant::emit
