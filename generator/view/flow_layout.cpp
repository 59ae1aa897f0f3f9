// Coordinates of the signal flow: parts, columns, and the curves of arrows.
#include "view/flow_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "view/flow_part.hpp"

namespace symplant::view {
namespace {

using model::kNone;

constexpr int kFlowMargin = 16;
constexpr int kPartGap = 32;
constexpr int kMostFlowWidth = 1600;  // of a row of parts
constexpr int kLeastColumn = 12;
constexpr int kLeastChannel = 48;
constexpr int kMostChannel = 144;
constexpr int kTurn = 30;  // how far an arrow that turns back reaches into the space between columns

/// The boxes that arrows join, and these arrows. A source belongs to each part that reads it.
struct FlowBoxes {
  std::vector<std::uint32_t> boxes;
  std::vector<std::uint32_t> arrows;
};

std::vector<FlowBoxes> parts_of(const Flow& flow) {
  const std::size_t count = flow.boxes.size();
  const auto is_source = [&](std::uint32_t box) { return flow.boxes[box].kind == FlowBox::Kind::source; };
  std::vector<std::uint32_t> root(count);
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](std::uint32_t box) {
    while (root[box] != box) box = root[box] = root[root[box]];
    return box;
  };
  for (const FlowArrow& arrow : flow.arrows) {
    if (is_source(arrow.from)) continue;
    const auto [first, second] = std::minmax({root_of(arrow.from), root_of(arrow.to)});
    root[second] = first;
  }
  std::vector<FlowBoxes> parts;
  std::vector<std::uint32_t> part_of(count, kNone);
  for (std::uint32_t box = 0; box < count; ++box) {
    if (is_source(box)) continue;
    std::uint32_t& part = part_of[root_of(box)];
    if (part == kNone) {
      part = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    parts[part].boxes.push_back(box);
  }
  for (std::uint32_t a = 0; a < flow.arrows.size(); ++a) {
    FlowBoxes& part = parts[part_of[root_of(flow.arrows[a].to)]];
    part.arrows.push_back(a);
    if (is_source(flow.arrows[a].from)) part.boxes.push_back(flow.arrows[a].from);
  }
  for (FlowBoxes& part : parts) {
    std::sort(part.boxes.begin(), part.boxes.end());
    part.boxes.erase(std::unique(part.boxes.begin(), part.boxes.end()), part.boxes.end());
  }
  return parts;
}

/// Draws one part with its upper left corner at the origin.
class PartDrawer {
 public:
  PartDrawer(const Flow& flow, const FlowBoxes& part)
      : flow_(flow), part_(lay_out_part(flow, part.boxes, part.arrows)) {
    place_columns();
    place_boxes();
    place_inputs();
    for (std::size_t i = 0; i < part_.edges.size(); ++i) add_arrow(part_.edges[i], inputs_[i]);
  }

  FlowLayout result() && { return std::move(layout_); }

 private:
  struct FlowColumn {
    int left = 0;
    int right = 0;
  };

  void place_columns() {
    const std::size_t count = part_.layers.size();
    std::vector<int> widths(count, kLeastColumn);
    std::vector<int> arrows(count + 1);  // in the space before each column, and after the last one
    bool turns_first = false;
    bool turns_last = false;
    for (const FlowNode& node : part_.nodes) {
      if (node.is_lane()) continue;
      std::uint32_t most = 0;
      for (const std::string& line : flow_.boxes[node.box].lines) most = std::max(most, columns(line));
      widths[node.layer] = std::max(widths[node.layer], static_cast<int>(most) * kLetterWidth + 2 * kFlowTextLeft);
    }
    for (const FlowEdge& edge : part_.edges) {
      const std::uint32_t from = part_.nodes[edge.from].layer;
      const std::uint32_t to = part_.nodes[edge.to].layer;
      if (!edge.back) {
        for (std::uint32_t layer = from + 1; layer <= to; ++layer) ++arrows[layer];
        continue;
      }
      turns_first = turns_first || to == 0;
      turns_last = turns_last || from + 1 == count;
      ++arrows[to];
      ++arrows[from + 1];
    }
    int x = turns_first ? kTurn : 0;
    for (std::size_t layer = 0; layer < count; ++layer) {
      if (layer > 0) x += std::min(kLeastChannel + 4 * arrows[layer], kMostChannel);
      columns_.push_back({x, x + widths[layer]});
      x += widths[layer];
    }
    layout_.width = x + (turns_last ? kTurn : 0);
  }

  void place_boxes() {
    for (const FlowNode& node : part_.nodes) {
      const int top = node.y - node.height / 2;
      layout_.height = std::max(layout_.height, top + node.height);
      if (node.is_lane()) continue;
      const FlowColumn& column = columns_[node.layer];
      layout_.boxes.push_back({node.box, column.left, top, column.right - column.left, node.height - node.loop});
    }
  }

  /// Where each arrow ends at the left side of its box: from top to bottom as they come.
  void place_inputs() {
    std::vector<std::vector<std::pair<int, std::uint32_t>>> inputs(layout_.boxes.size());
    for (std::uint32_t i = 0; i < part_.edges.size(); ++i) {
      const FlowEdge& edge = part_.edges[i];
      const std::uint32_t before = edge.lanes.empty() ? edge.from : edge.lanes.back();
      const int from =
          edge.from == edge.to ? layout_.boxes[edge.to].y + part_.nodes[edge.to].height : part_.nodes[before].y;
      inputs[edge.to].emplace_back(from, i);
    }
    inputs_.resize(part_.edges.size());
    for (std::size_t box = 0; box < inputs.size(); ++box) {
      std::sort(inputs[box].begin(), inputs[box].end());
      const auto count = static_cast<int>(inputs[box].size());
      const FlowLayout::Box& at = layout_.boxes[box];
      for (int i = 0; i < count; ++i) {
        inputs_[inputs[box][static_cast<std::size_t>(i)].second] = at.y + at.height * (i + 1) / (count + 1);
      }
    }
  }

  void curve(Point first_control, Point second_control, Point end) {
    points_.insert(points_.end(), {first_control, second_control, end});
  }
  void line_to(Point end) {
    const Point begin = points_.back();
    curve({begin.x + (end.x - begin.x) / 3, begin.y}, {end.x - (end.x - begin.x) / 3, end.y}, end);
  }
  /// Begins and ends horizontally.
  void swing_to(Point end) {
    const int middle = (points_.back().x + end.x) / 2;
    curve({middle, points_.back().y}, {middle, end.y}, end);
  }
  /// Turns back: reaches out to the right or left on its path.
  void turn_to(Point end, int reach) {
    curve({points_.back().x + reach, points_.back().y}, {end.x + reach, end.y}, end);
  }

  void add_arrow(const FlowEdge& edge, int input) {
    const FlowLayout::Box& from = layout_.boxes[edge.from];
    const FlowLayout::Box& to = layout_.boxes[edge.to];
    const Point end{to.x, input};
    points_ = {{from.x + from.width, from.y + from.height / 2}};
    constexpr int kReach = kTurn * 4 / 3;  // of control points: the curve itself reaches kTurn
    if (edge.from == edge.to) {
      const int below = from.y + from.height + part_.nodes[edge.from].loop / 2;
      turn_to({from.x + from.width, below}, kReach);
      line_to({from.x, below});
      turn_to(end, -kReach);
    } else if (edge.back && !edge.lanes.empty()) {
      for (const std::uint32_t lane : edge.lanes) {
        const FlowColumn& column = columns_[part_.nodes[lane].layer];
        const Point begin{column.right, part_.nodes[lane].y};
        if (lane == edge.lanes.front()) {
          turn_to(begin, kReach);
        } else {
          swing_to(begin);
        }
        line_to({column.left, part_.nodes[lane].y});
      }
      turn_to(end, -kReach);
    } else {
      for (const std::uint32_t lane : edge.lanes) {
        const FlowColumn& column = columns_[part_.nodes[lane].layer];
        swing_to({column.left, part_.nodes[lane].y});
        line_to({column.right, part_.nodes[lane].y});
      }
      swing_to(end);
    }
    layout_.arrows.push_back({edge.arrow, edge.from, edge.to, std::move(points_)});
  }

  const Flow& flow_;
  const FlowPart part_;
  FlowLayout layout_;
  std::vector<FlowColumn> columns_;
  std::vector<int> inputs_;  // y of the end of each edge
  std::vector<Point> points_;
};

/// Adds a part at a position.
void add_part(FlowLayout&& part, int x, int y, FlowLayout& layout) {
  const auto first = static_cast<std::uint32_t>(layout.boxes.size());
  for (FlowLayout::Box& box : part.boxes) {
    box.x += x;
    box.y += y;
    layout.boxes.push_back(box);
  }
  for (FlowLayout::Arrow& arrow : part.arrows) {
    arrow.from += first;
    arrow.to += first;
    for (Point& point : arrow.points) point = {point.x + x, point.y + y};
    layout.arrows.push_back(std::move(arrow));
  }
  layout.width = std::max(layout.width, x + part.width + kFlowMargin);
  layout.height = std::max(layout.height, y + part.height + kFlowMargin);
}

}  // namespace

FlowLayout lay_out(const Flow& flow) {
  FlowLayout layout;
  int x = kFlowMargin;
  int y = kFlowMargin;
  for (const FlowBoxes& part : parts_of(flow)) {
    FlowLayout drawn = PartDrawer(flow, part).result();
    if (x > kFlowMargin && x + drawn.width > kMostFlowWidth) {
      x = kFlowMargin;
      y = layout.height - kFlowMargin + kPartGap;
    }
    const int width = drawn.width;
    add_part(std::move(drawn), x, y, layout);
    x += width + kPartGap;
  }
  return layout;
}

std::string path_text(const std::vector<Point>& points) {
  std::string text = fmt::format("M{} {}", points[0].x, points[0].y);
  for (std::size_t i = 1; i + 2 < points.size(); i += 3) {
    fmt::format_to(std::back_inserter(text), "C{} {} {} {} {} {}", points[i].x, points[i].y, points[i + 1].x,
                   points[i + 1].y, points[i + 2].x, points[i + 2].y);
  }
  return text;
}

}  // namespace symplant::view
