// The layout of the signal flow: nothing overlaps, arrows lead to the right and around boxes, whatever the graph.
#include "view/flow_layout.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>

#include "flow_support.hpp"

namespace symplant::test {
namespace {

using view::Flow;
using view::FlowBox;
using view::FlowLayout;
using view::Point;

/// `sources`, then `values`, then `sinks` boxes; the arrows are pairs of indexes.
Flow flow_with(std::uint32_t sources, std::uint32_t values, std::uint32_t sinks,
               const std::set<std::pair<std::uint32_t, std::uint32_t>>& arrows) {
  Flow flow;
  for (std::uint32_t b = 0; b < sources + values + sinks; ++b) {
    FlowBox box;
    box.kind = b < sources ? FlowBox::Kind::source : b < sources + values ? FlowBox::Kind::value : FlowBox::Kind::sink;
    box.lines = {"box " + std::to_string(b), std::string(1 + b * 7 % 40, 'x')};
    if (b % 3 == 0) box.lines.emplace_back("a third line");
    flow.boxes.push_back(std::move(box));
  }
  for (const auto& [from, to] : arrows) flow.arrows.push_back({from, to, (from + to) % 4 == 0});
  return flow;
}

/// Random arrows: from sources and values to values and sinks.
Flow random_flow(std::uint32_t seed, std::uint32_t sources, std::uint32_t values, std::uint32_t sinks,
                 std::uint32_t arrows) {
  const auto below = [&](std::uint32_t end) {
    seed = seed * 1664525 + 1013904223;
    return static_cast<std::uint32_t>((std::uint64_t{seed} * end) >> 32U);
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t s = 0; s < sources; ++s) pairs.insert({s, sources + below(values)});
  for (std::uint32_t s = 0; s < sinks; ++s) pairs.insert({sources + below(values), sources + values + s});
  for (std::uint32_t a = 0; a < arrows; ++a) {
    pairs.insert({below(sources + values), sources + below(values + sinks)});
  }
  return flow_with(sources, values, sinks, pairs);
}

bool inside(const FlowLayout::Box& box, Point point, int margin) {
  return point.x > box.x + margin && point.x < box.x + box.width - margin && point.y > box.y + margin &&
         point.y < box.y + box.height - margin;
}

Point on_curve(const Point* points, int step, int steps) {
  const double t = static_cast<double>(step) / steps;
  const double u = 1 - t;
  const auto at = [&](double a, double b, double c, double d) {
    return static_cast<int>(u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
  };
  return {at(points[0].x, points[1].x, points[2].x, points[3].x),
          at(points[0].y, points[1].y, points[2].y, points[3].y)};
}

void check_arrows(const Flow& flow, const FlowLayout& layout) {
  std::multiset<std::uint32_t> drawn;
  std::size_t through_boxes = 0;
  std::size_t outside = 0;
  std::size_t loose = 0;
  for (const FlowLayout::Arrow& arrow : layout.arrows) {
    drawn.insert(arrow.arrow);
    const FlowLayout::Box& from = layout.boxes.at(arrow.from);
    const FlowLayout::Box& to = layout.boxes.at(arrow.to);
    loose += from.box == flow.arrows[arrow.arrow].from && to.box == flow.arrows[arrow.arrow].to ? 0U : 1U;
    const Point begin = arrow.points.front();
    const Point end = arrow.points.back();
    loose += begin.x == from.x + from.width && begin.y > from.y && begin.y < from.y + from.height ? 0U : 1U;
    loose += end.x == to.x && end.y > to.y && end.y < to.y + to.height ? 0U : 1U;
    for (std::size_t i = 0; i + 3 < arrow.points.size(); i += 3) {
      for (int step = 0; step <= 16; ++step) {
        const Point point = on_curve(&arrow.points[i], step, 16);
        if (point.x < 0 || point.y < 0 || point.x > layout.width || point.y > layout.height) ++outside;
        for (const FlowLayout::Box& box : layout.boxes) through_boxes += inside(box, point, 1) ? 1U : 0U;
      }
    }
  }
  CHECK(through_boxes == 0);
  CHECK(outside == 0);
  CHECK(loose == 0);
  CHECK(drawn.size() == flow.arrows.size());
  CHECK(std::set<std::uint32_t>(drawn.begin(), drawn.end()).size() == flow.arrows.size());
}

void check_boxes(const Flow& flow, const FlowLayout& layout) {
  std::multiset<std::uint32_t> drawn;
  std::size_t touching = 0;
  for (std::size_t a = 0; a < layout.boxes.size(); ++a) {
    const FlowLayout::Box& box = layout.boxes[a];
    drawn.insert(box.box);
    if (box.x < 0 || box.y < 0 || box.x + box.width > layout.width || box.y + box.height > layout.height) ++touching;
    for (const std::string& line : flow.boxes[box.box].lines) {
      if (static_cast<int>(view::columns(line)) * view::kLetterWidth + view::kFlowTextLeft > box.width) ++touching;
    }
    for (std::size_t b = a + 1; b < layout.boxes.size(); ++b) {
      const FlowLayout::Box& other = layout.boxes[b];
      const bool apart = box.x + box.width < other.x || other.x + other.width < box.x || box.y + box.height < other.y ||
                         other.y + other.height < box.y;
      touching += apart ? 0U : 1U;
    }
  }
  CHECK(touching == 0);
  for (std::uint32_t b = 0; b < flow.boxes.size(); ++b) {
    const std::size_t count = drawn.count(b);
    CHECK((flow.boxes[b].kind == FlowBox::Kind::source || count == 1));
  }
}

FlowLayout checked(const Flow& flow) {
  FlowLayout layout = view::lay_out(flow);
  check_boxes(flow, layout);
  check_arrows(flow, layout);
  return layout;
}

/// How many arrows lead to the left, or to a box of the same column.
std::size_t returning(const FlowLayout& layout) {
  return static_cast<std::size_t>(std::count_if(layout.arrows.begin(), layout.arrows.end(), [&](const auto& arrow) {
    return layout.boxes[arrow.to].x <= layout.boxes[arrow.from].x;
  }));
}

}  // namespace

TEST_CASE("The layout of no box is empty, and of one box it is the box") {
  CHECK(view::lay_out(Flow{}).boxes.empty());
  const FlowLayout one = checked(flow_with(0, 1, 0, {}));
  CHECK(one.boxes.size() == 1);
  CHECK(one.width == one.boxes[0].width + 2 * one.boxes[0].x);
}

TEST_CASE("Without a circle all arrows lead to the right") {
  CHECK(returning(checked(flow_with(1, 4, 1, {{0, 1}, {1, 2}, {2, 3}, {1, 4}, {4, 3}, {0, 3}, {3, 5}, {1, 5}}))) == 0);
}

TEST_CASE("One arrow of a circle returns, and so does that of a value that reads itself") {
  CHECK(returning(checked(flow_with(0, 2, 0, {{0, 1}, {1, 0}}))) == 1);
  CHECK(returning(checked(flow_with(0, 1, 0, {{0, 0}}))) == 1);
  const Flow loop = flow_with(2, 5, 1, {{0, 4}, {4, 5}, {5, 6}, {6, 2}, {2, 4}, {6, 6}, {6, 7}, {1, 3}, {3, 5}});
  CHECK(returning(checked(loop)) == 2);
}

TEST_CASE("A circle begins with the value that reads from the border") {
  const FlowLayout layout = checked(flow_with(1, 3, 0, {{1, 2}, {2, 3}, {3, 1}, {0, 3}}));
  const auto x_of = [&](std::uint32_t box) {
    return std::find_if(layout.boxes.begin(), layout.boxes.end(), [&](const auto& at) { return at.box == box; })->x;
  };
  CHECK(x_of(0) < x_of(3));
  CHECK(x_of(3) < x_of(1));
  CHECK(x_of(1) < x_of(2));
}

TEST_CASE("Sources are at the left border, sinks at the right one, and a parameter is next to what reads it") {
  // 0 and 1 are sources, 6 and 7 sinks; the parameter 5 is read by the end of the chain 2, 3, 4.
  const FlowLayout layout = checked(flow_with(2, 4, 2, {{0, 2}, {1, 4}, {2, 3}, {3, 4}, {5, 4}, {2, 6}, {4, 7}}));
  const auto x_of = [&](std::uint32_t box) {
    return std::find_if(layout.boxes.begin(), layout.boxes.end(), [&](const auto& at) { return at.box == box; })->x;
  };
  CHECK(x_of(0) == x_of(1));
  CHECK(x_of(6) == x_of(7));
  CHECK(x_of(5) == x_of(3));
  CHECK(x_of(0) < x_of(2));
  CHECK(x_of(4) < x_of(6));
}

TEST_CASE("Parts that nothing joins are apart, each with the sources that it reads") {
  const FlowLayout layout = checked(flow_with(1, 2, 0, {{0, 1}, {0, 2}}));
  CHECK(layout.boxes.size() == 4);
}

TEST_CASE("No arrow crosses a box and no box another one in random graphs") {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const std::uint32_t values = 2 + seed % 30;
    checked(random_flow(seed, seed % 6, values, seed % 5, values * (1 + seed % 4)));
  }
}

TEST_CASE("The layout is the same each time") {
  const Flow flow = random_flow(7, 5, 40, 5, 90);
  const FlowLayout first = view::lay_out(flow);
  const FlowLayout second = view::lay_out(flow);
  REQUIRE(first.arrows.size() == second.arrows.size());
  for (std::size_t a = 0; a < first.arrows.size(); ++a) {
    CHECK(view::path_text(first.arrows[a].points) == view::path_text(second.arrows[a].points));
  }
}

TEST_CASE("A thousand values are laid out: joined at random, in a chain, alone, all from one, and a circle of 200") {
  const auto count = std::uint32_t{1000};
  const auto with = [&](const std::function<void(std::set<std::pair<std::uint32_t, std::uint32_t>>&)>& fill) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> arrows;
    fill(arrows);
    return checked(flow_with(0, count, 0, arrows));
  };
  check_boxes(random_flow(1, 40, count, 40, 1500), view::lay_out(random_flow(1, 40, count, 40, 1500)));
  with([](auto&) {});
  with([&](auto& arrows) {
    for (std::uint32_t v = 1; v < count; ++v) arrows.insert({v - 1, v});
  });
  with([&](auto& arrows) {
    for (std::uint32_t v = 1; v < count; ++v) arrows.insert({0, v});
  });
  with([&](auto& arrows) {
    for (std::uint32_t v = 0; v < 200; ++v) arrows.insert({v, (v + 1) % 200});
  });
}

TEST_CASE("Arrows that would need too many lanes are drawn without them") {
  // A chain of 500 values, each of which also reads every seventh before it.
  std::set<std::pair<std::uint32_t, std::uint32_t>> arrows;
  for (std::uint32_t v = 1; v < 500; ++v) {
    arrows.insert({v - 1, v});
    for (std::uint32_t before = v % 7; before + 1 < v; before += 7) arrows.insert({before, v});
  }
  const Flow flow = flow_with(0, 500, 0, arrows);
  const FlowLayout layout = view::lay_out(flow);
  check_boxes(flow, layout);
  CHECK(layout.arrows.size() == flow.arrows.size());
  CHECK(std::all_of(layout.arrows.begin(), layout.arrows.end(),
                    [](const FlowLayout::Arrow& arrow) { return arrow.points.size() == 4; }));
}

TEST_CASE("Arrows that share lanes, but would pass too many of them, are drawn without them") {
  // A chain whose values all read its first one: 998 lanes, of which the arrows would pass 498,501.
  std::set<std::pair<std::uint32_t, std::uint32_t>> arrows;
  for (std::uint32_t v = 1; v < 1000; ++v) arrows.insert({{v - 1, v}, {0, v}});
  const FlowLayout layout = view::lay_out(flow_with(0, 1000, 0, arrows));
  CHECK(std::all_of(layout.arrows.begin(), layout.arrows.end(),
                    [](const FlowLayout::Arrow& arrow) { return arrow.points.size() == 4; }));
}

TEST_CASE("A path of SVG has one curve for three points") {
  CHECK(view::path_text({{1, 2}, {3, 4}, {5, 6}, {7, 8}}) == "M1 2C3 4 5 6 7 8");
}

}  // namespace symplant::test
