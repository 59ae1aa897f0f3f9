// From named symbols to the plant model: which rows are I/O, which device they belong to, and what the device is.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "name/named_table.hpp"

namespace symplant::model {

/// One symbol list, read and its names read.
struct ListInput {
  std::shared_ptr<const read::SymbolTable> table;
  name::NamedTable named;              ///< of `*table`
  std::string controller{};            ///< whose addresses these are; empty: the default one
  std::optional<address::Radix> xy{};  ///< nothing: proved by rows, else hexadecimal
};

struct BuildOptions {
  std::string plant_name;
  std::shared_ptr<const description::Description> description =
      nullptr;  ///< null: nothing is said beyond the symbols' names
};

/// Derives the whole model from the plant's lists, of which there must be one at least and which one rule has named.
/// Names of controllers compare without regard to the case of ASCII letters. Finds no fault with the lists, but records
/// what the checks will want to know; faults of the description are in PlantModel::description_faults. O(rows), and
/// O(states squared) within one unit; of a description O(its entries), a `*` counting as one a state.
PlantModel build_plant(const std::vector<ListInput>& lists, const BuildOptions& options);

}  // namespace symplant::model
