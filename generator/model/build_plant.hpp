// From named symbols to the plant model: which rows are I/O, which device they belong to, and what the device is.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/plant_model.hpp"
#include "name/named_table.hpp"

namespace symplant::model {

struct BuildOptions {
  std::string plant_name;
  std::optional<address::Radix> radix;  ///< --xy; nothing: proved by rows, else hexadecimal
};

/// Derives the whole model; finds no fault with anything, but records what the checks will want to know.
/// `named.table` must be what `list` points to. O(rows), and O(states squared) within one unit.
PlantModel build_plant(std::shared_ptr<const read::SymbolTable> list, const name::NamedTable& named,
                       const BuildOptions& options);

}  // namespace symplant::model
