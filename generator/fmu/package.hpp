// An FMU: the container with description, library and tables.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "fmu/library.hpp"
#include "model/plant_model.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::fmu {

struct PackageError {
  std::string message;
};

/// The bytes of the FMU with these libraries, of which no two have the same platform. `identifier` is their name in it.
/// Equal inputs give equal bytes. An error is a name that two variables have, or of the container. O(tables +
/// libraries).
base::Result<std::string, PackageError> package(const model::PlantModel& plant, const tables::PlantTables& tables,
                                                const std::string& identifier, std::span<const Library> libraries);

}  // namespace symplant::fmu
