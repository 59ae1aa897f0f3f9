// Values and the signal flow for the page.
#include "elements/value/html.hpp"

#include <string>

#include "diag/visible_text.hpp"
#include "elements/value/words.hpp"
#include "view/flow_layout.hpp"

namespace symplant::view {
namespace {

using diag::visible;
using model::kNone;

void write_lines(const std::vector<std::string>& lines, JsonWriter& json) {
  json.array(lines, [&](const std::string& line) { json.value(visible(line)); });
}

}  // namespace

void write_page_values(const Scene& scene, const std::vector<int>& unit_positions, JsonWriter& json) {
  const Flow flow = flow_of(scene);
  if (flow.empty()) return;
  const FlowLayout layout = lay_out(flow);
  std::vector<int> positions(scene.plant.values.size(), -1);
  json.key("values");
  json.begin_object();
  json.key("list");
  json.begin_array();
  int shown = 0;
  for (const FlowBox& box : flow.boxes) {
    if (box.value == kNone) continue;
    const model::Value& value = scene.plant.values[box.value];
    positions[box.value] = shown++;
    json.row(visible(value.name), visible(value.unit), visible(value_line(value, scene.plant)));
  }
  json.end_array();
  json.key("signals");
  json.array(scene.plant.signals, [&](const model::Signal& signal) {
    json.row(visible(scene.plant.symbols[signal.row.symbol].name()), visible(signal_line(signal, scene.plant)));
  });
  json.member("width", layout.width);
  json.member("height", layout.height);
  // The elements are in the order that drawFlow() of page.js expects.
  json.key("boxes");
  json.array(layout.boxes, [&](const FlowLayout::Box& at) {
    const FlowBox& box = flow.boxes[at.box];
    json.begin_array();
    for (const int number : {at.x, at.y, at.width, at.height}) json.value(number);
    json.value(flow_class(box.kind));
    write_lines(box.lines, json);
    write_lines(box.whole, json);
    json.value(box.value == kNone ? -1 : positions[box.value]);
    json.value(box.unit == kNone ? -1 : unit_positions[box.unit]);
    json.end_array();
  });
  json.key("arrows");
  json.array(layout.arrows, [&](const FlowLayout::Arrow& arrow) {
    json.row(arrow.from, arrow.to, flow.arrows[arrow.arrow].in_condition ? 1 : 0, path_text(arrow.points));
  });
  json.end_object();
}

}  // namespace symplant::view
