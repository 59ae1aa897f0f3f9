// Device types, shared by units of equal structure.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

class TypeTable {
 public:
  /// The type of a unit: an existing one if its structure and the names in it are equal. O(structure).
  std::uint32_t type_of(const model::PlantModel& plant, std::uint32_t unit, std::vector<Type>& types);

 private:
  std::unordered_map<std::string, std::uint32_t> by_structure_;
  Type type_{};            ///< of the current unit
  std::string structure_;  ///< of the current unit
};

}  // namespace symplant::lower
