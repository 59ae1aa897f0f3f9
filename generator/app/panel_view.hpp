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
  /// O(units * log(stations) + symbols + alarms).
  explicit PanelView(const model::PlantModel& plant);
  PanelView(const PanelView&) = delete;
  PanelView& operator=(const PanelView&) = delete;

  /// The result refers to this object.
  panel::View view() const { return {devices_, stations_, symbols_, alarms_}; }

 private:
  std::string stations_;
  std::string comments_;  ///< one after the other
  std::vector<panel::DeviceView> devices_;
  std::vector<panel::SymbolView> symbols_;
  std::vector<panel::AlarmView> alarms_;
};

}  // namespace symplant::app
