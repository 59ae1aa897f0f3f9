// Resolves one effect of a malfunction.
#pragma once

#include <string>
#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "model/plant_names.hpp"

namespace symplant::model {

/// Devices and tracks as the description names them, and where it does.
struct GivenDevices {
  const std::vector<std::string>& names;
  description::Pointer here;
  bool is_list = false;
};

/// Whether an effect of this kind acts on devices or tracks.
inline bool names_devices(tables::MalfunctionKind kind) {
  return kind == tables::MalfunctionKind::slower || kind == tables::MalfunctionKind::stuck;
}

/// `given` has one kind; `of` is used if that names devices. O(symbols of a pattern).
Effect resolve_effect(const PlantModel& plant, const PlantNames& names, const description::GivenEffect& given,
                      const GivenDevices& of, const description::Pointer& here, description::Faults& faults);

}  // namespace symplant::model
