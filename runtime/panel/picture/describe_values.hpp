// The description of values for the panel's clients.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// The units by their names; a device with several units by its own name, too, as its first unit.
class UnitNames {
 public:
  /// `names` must outlive it. O(units * log(units)).
  explicit UnitNames(const trace::PlantNames& names);

  /// The unit with the longest name with which a value's name begins, before a dot; otherwise kNone. O(log(units)).
  std::uint32_t of_value(std::string_view value) const;

 private:
  std::map<std::string_view, std::uint32_t> units_;
};

/// Appends the key `values` of `GET /api/v1/plant`: each output of each value. O(values * log(units)).
void put_values(std::string& json, const trace::PlantNames& names);

}  // namespace symplant::panel
