// Devices that lack what nearly all others named like them have.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/rule.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// A symbol of the others that a device lacks.
struct Lacking {
  const model::Symbol* others;  ///< of one that has it
  std::string name;             ///< as the odd device's would be
  std::uint32_t having;         ///< how many of its class have it
};

struct OddDevice {
  std::uint32_t device;  ///< index in DeviceClasses: that in PlantModel::units, or after them if it has numbers only
  std::string_view path;
  std::uint32_t of;            ///< the size of its class
  std::vector<Lacking> lacks;  ///< never empty
  bool one_task;               ///< it has one task only, and lacks every symbol of another
};

/// Subjects of a finding about the device: the device and what it lacks.
diag::Subjects about(const OddDevice& odd);

/// By index of the device. Three quarters of a class must have a symbol, three devices at least; if more than one in
/// eight lack it, and more than one, that counts as intended. The device must have half of what is common in its class,
/// or the one task. Numeric symbols count as the others do. O(symbols).
std::vector<OddDevice> odd_devices(const Subject& subject);

}  // namespace symplant::check
