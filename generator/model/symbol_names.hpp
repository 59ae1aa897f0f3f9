// Finds symbols by name, for entries of the description.
#pragma once

#include <cstdint>
#include <string>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

class SymbolNames {
 public:
  /// O(symbols). The plant must outlive this object.
  explicit SymbolNames(const PlantModel& plant) : plant_(plant) {
    by_name_.reserve(plant.symbols.size());
    for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) by_name_.try_emplace(plant.symbols[i].name(), i);
  }

  /// kNone, and a fault with the nearest name, if there is no such symbol.
  std::uint32_t find(const std::string& name, const description::Pointer& here, description::Faults& faults) const {
    if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
    const auto nearest = faults.nearest(name, plant_.symbols.size(),
                                        [&](std::size_t i) -> std::string_view { return plant_.symbols[i].name(); });
    faults.add(here, description::missing("symbol " + description::ticked(name), nearest),
               description::FaultKind::unknown_name);
    return kNone;
  }

 private:
  const PlantModel& plant_;
  text::ByName<std::uint32_t> by_name_;
};

}  // namespace symplant::model
