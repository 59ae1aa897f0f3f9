// The layout, comments and alarms of a plant for its panel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/panel/view.hpp"

namespace symplant::app {

/// Owns the rows of a panel::View.
class PanelView {
 public:
  /// `plant_file`: the path of the description or list. O(units * log(stations) + symbols + alarms).
  PanelView(const model::PlantModel& plant, std::string_view plant_file);
  PanelView(const PanelView&) = delete;
  PanelView& operator=(const PanelView&) = delete;

  /// The result refers to this object.
  panel::View view() const { return {devices_, stations_, symbols_, alarms_, shapes_, plan_, view3d_, folder_}; }

 private:
  std::string stations_;
  std::string comments_;  ///< one after the other
  std::vector<panel::DeviceView> devices_;
  std::vector<panel::SymbolView> symbols_;
  std::vector<panel::AlarmView> alarms_;
  std::vector<tables::Shape> shapes_;
  std::string plan_;
  std::string view3d_;
  std::string folder_;
};

}  // namespace symplant::app
