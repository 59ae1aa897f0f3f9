// The structures and layouts that devices share in the data of the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/plant_model.hpp"
#include "view/chart.hpp"
#include "view/json_writer.hpp"
#include "view/layout.hpp"

namespace symplant::view {

/// Each structure and each layout once, in the order of their first devices.
class PageKinds {
 public:
  explicit PageKinds(const model::PlantModel& plant) : plant_(plant) {}

  /// The index of a unit's structure: all data that is equal in units of the same structure. O(transitions).
  std::uint32_t of(const model::Unit& unit);
  /// Writes the members "layouts" and "kinds".
  void write(JsonWriter& json) const;

 private:
  std::size_t layout_of(const Chart& chart);

  const model::PlantModel& plant_;
  std::map<LayoutKey, std::size_t> layout_positions_;
  std::vector<const LayoutKey*> layouts_;  ///< keys of `layout_positions_`
  std::unordered_map<std::string, std::uint32_t> positions_;
  std::vector<std::string_view> texts_;  ///< keys of `positions_`
};

}  // namespace symplant::view
