// The layout of a plant for its panel.
#pragma once

#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/panel/view.hpp"

namespace symplant::app {

/// Owns the rows of a panel::View.
class PanelView {
 public:
  explicit PanelView(const model::PlantModel& plant);

  /// The result refers to this object.
  panel::View view() const { return {devices_, stations_}; }

 private:
  std::string stations_;
  std::vector<panel::DeviceView> devices_;
};

}  // namespace symplant::app
