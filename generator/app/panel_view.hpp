// The layout, comments and alarms of a plant for its panel.
#pragma once

#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/panel/view.hpp"

namespace symplant::app {

/// Owns the rows of a panel::View.
class PanelView {
 public:
  /// The result refers to texts of the plant. O(units * log(stations) + symbols + alarms).
  explicit PanelView(const model::PlantModel& plant);

  /// The result refers to this object and to the plant.
  panel::View view() const { return {devices_, stations_, symbols_, alarms_}; }

 private:
  std::string stations_;
  std::vector<panel::DeviceView> devices_;
  std::vector<panel::SymbolView> symbols_;
  std::vector<panel::AlarmView> alarms_;
};

}  // namespace symplant::app
