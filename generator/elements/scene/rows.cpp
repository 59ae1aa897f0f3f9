// The panel's plan and 3D view as rows of generated code.
#include "elements/scene/rows.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "emit/row_writer.hpp"
#include "model/plan_shapes.hpp"

namespace symplant::emit {

std::string shape_rows(const model::PlantModel& plant) {
  const std::vector<tables::Shape> shapes = model::plan_shapes(plant);
  const auto is_plain = [](tables::Shape shape) { return shape == tables::Shape::device; };
  if (std::all_of(shapes.begin(), shapes.end(), is_plain)) return {};
  RowWriter rows;
  for (std::size_t unit = 0; unit < shapes.size(); ++unit) {
    rows.text("    symplant::tables::Shape::").text(tables::shape_name(shapes[unit])).text(",  // ");
    rows.comment(plant.units[unit].path).text("\n");
  }
  return rows.take();
}

std::string json_rows(std::string_view json) {
  constexpr std::size_t kLine = 90;
  RowWriter rows;
  for (std::size_t at = 0; at < json.size();) {
    std::size_t end = std::min(at + kLine, json.size());
    while (end < json.size() && (json[end] & '\xC0') == '\x80') ++end;  // within a character
    rows.text("    \"").literal(json.substr(at, end - at)).text("\"\n");
    at = end;
  }
  return rows.take();
}

}  // namespace symplant::emit
