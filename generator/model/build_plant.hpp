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
  std::optional<address::Radix> radix;                       ///< --xy; nothing: proved by rows, else hexadecimal
  std::shared_ptr<const Description> description = nullptr;  ///< null: nothing is said beyond the symbols' names
};

/// Derives the whole model. Finds no fault with the list, but records what the checks will want to know; faults of the
/// description are in PlantModel::description_faults. `named.table` must be what `list` points to. O(rows), and
/// O(states squared) within one unit; of a description O(its entries), a `*` counting as one a state.
PlantModel build_plant(std::shared_ptr<const read::SymbolTable> list, const name::NamedTable& named,
                       const BuildOptions& options);

}  // namespace symplant::model
