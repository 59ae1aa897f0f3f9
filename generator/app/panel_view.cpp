// The layout, comments and alarms of a plant for its panel.
#include "app/panel_view.hpp"

#include <filesystem>

#include "elements/alarm/resolve.hpp"
#include "model/layout.hpp"
#include "model/plan_shapes.hpp"

namespace symplant::app {
namespace {

std::string folder_of(std::string_view file) {
  const std::string folder = std::filesystem::path(file).parent_path().generic_string();
  return folder.empty() ? "." : folder;
}

}  // namespace

PanelView::PanelView(const model::PlantModel& plant, std::string_view plant_file) : folder_(folder_of(plant_file)) {
  std::size_t length = 0;
  for (const model::Symbol& symbol : plant.symbols) length += symbol.row->comment.size();
  comments_.reserve(length);  // so that no text moves
  symbols_.reserve(plant.symbols.size());
  for (const model::Symbol& symbol : plant.symbols) {
    const std::string_view comment = symbol.row->comment;
    comments_.append(comment);
    symbols_.push_back(
        {std::string_view(comments_).substr(comments_.size() - comment.size()), symbol.is_by_operator()});
  }
  for (const model::Alarm& alarm : model::alarms_by_output(plant)) {
    alarms_.push_back({alarm.symbol, alarm.value, alarm.priority});
  }
  shapes_ = model::plan_shapes(plant);
  plan_ = plant.description->scene.plan;
  view3d_ = plant.description->scene.view3d;
  if (!model::has_layout(plant)) return;
  const model::Layout layout = model::layout_of(plant);
  for (const model::Station& station : layout.stations) {
    stations_.append(station.line).push_back('\0');
    stations_.append(station.process).push_back('\0');
  }
  for (const model::DevicePlace& place : layout.devices) devices_.push_back({place.station, place.x, place.y});
}

}  // namespace symplant::app
