// Writes a first plant description: inferred facts as comments, possible settings as commented-out keys.
#pragma once

#include <string>

#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The reference to the list, with the settings that it was read with.
struct SkeletonList {
  std::string file;      ///< relative to the description
  std::string format;    ///< empty: detected
  std::string encoding;  ///< empty: detected
  std::string xy;        ///< `hex`, `octal`; empty: not given
  std::string naming;    ///< a naming.json relative to the description, or `@PROFILE`; empty: the built-in rule
};

/// The text of a valid plant.json that gives the same plant as the bare list. Each line with a key after `//` may be
/// uncommented, alone or together with others, and the text stays valid. One entry for each shape of devices.
std::string skeleton(const model::PlantModel& plant, const model::Evidence& evidence, const SkeletonList& list);

}  // namespace symplant::emit
