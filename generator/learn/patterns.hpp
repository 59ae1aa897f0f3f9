// Names devices that belong together by patterns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::learn {

/// A name or a pattern, and the devices that it is for.
struct DevicesName {
  std::string name;
  std::vector<std::uint32_t> units;  ///< ascending
};

/// Devices that may share an entry of plant.json.
struct NamedGroup {
  std::vector<std::uint32_t> units;  ///< ascending
  std::size_t keys = 0;              ///< equal for groups whose entries have the same keys: one may overrule another
  std::vector<DevicesName> names;    ///< result, by name
};

/// Gives each group names and patterns that match its devices and no other one, except devices of groups with the same
/// keys which have an exact name. Patterns of two groups never match one device. A pattern matches two devices or more.
/// O(units log units + groups * matched units).
void name_groups(const model::PlantModel& plant, std::vector<NamedGroup>& groups);

}  // namespace symplant::learn
