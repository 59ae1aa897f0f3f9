// The tool's own layout: which elements must not overlap.
#include "view/layout.hpp"

#include <cstdlib>

#include "view_support.hpp"

namespace symplant::test {
namespace {

using view::LayoutKey;

LayoutKey ring(std::uint32_t states) {
  LayoutKey key{states, 12, {}};
  for (std::uint32_t s = 0; s < states; ++s) key.arrows.push_back({s, (s + 1) % states, 2, 24});
  return key;
}

LayoutKey complete(std::uint32_t states) {
  LayoutKey key{states, 8, {}};
  for (std::uint32_t to = 0; to < states; ++to) {
    for (std::uint32_t from = 0; from < states; ++from) {
      if (from != to) key.arrows.push_back({from, to, 1, 16});
    }
  }
  return key;
}

LayoutKey star(std::uint32_t states) {
  LayoutKey key{states, 8, {}};
  for (std::uint32_t s = 1; s < states; ++s) {
    key.arrows.push_back({0, s, 1, 20});
    key.arrows.push_back({s, 0, 2, 20});
  }
  return key;
}

/// Any operation leads anywhere, and the states also follow each other.
LayoutKey every(std::uint32_t states) {
  LayoutKey key = ring(states);
  for (std::uint32_t s = 0; s < states; ++s) key.arrows.push_back({view::kEveryOther, s, 1, 20});
  return key;
}

bool apart(view::Point a, int width_a, int height_a, view::Point b, int width_b, int height_b) {
  return 2 * std::abs(a.x - b.x) >= width_a + width_b || 2 * std::abs(a.y - b.y) >= height_a + height_b;
}

void check_clear(const LayoutKey& key) {
  const view::Layout layout = view::lay_out(key);
  INFO(key.states << " states, " << key.arrows.size() << " arrows");
  REQUIRE(layout.states.size() == key.states);
  REQUIRE(layout.arrows.size() == key.arrows.size());
  const auto width = [&](std::size_t i) { return static_cast<int>(key.arrows[i].columns) * view::kLetterWidth; };
  const auto height = [&](std::size_t i) { return static_cast<int>(key.arrows[i].lines) * view::kLineHeight; };
  for (std::size_t i = 0; i < layout.states.size(); ++i) {
    const view::Point& a = layout.states[i];
    CHECK(a.x - layout.box_width / 2 >= 0);
    CHECK(a.x + layout.box_width / 2 <= layout.width);
    CHECK(a.y - layout.box_height / 2 >= 0);
    CHECK(a.y + layout.box_height / 2 <= layout.height);
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(apart(a, layout.box_width, layout.box_height, layout.states[j], layout.box_width, layout.box_height));
    }
  }
  for (std::size_t i = 0; i < layout.arrows.size(); ++i) {
    const view::Point& label = layout.arrows[i].label;
    CHECK(label.x - width(i) / 2 >= 0);
    CHECK(label.x + width(i) / 2 <= layout.width);
    CHECK(label.y - height(i) / 2 >= 0);
    CHECK(label.y + height(i) / 2 <= layout.height);
    for (const view::Point& state : layout.states) {
      CHECK(apart(label, width(i), height(i), state, layout.box_width, layout.box_height));
    }
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(apart(label, width(i), height(i), layout.arrows[j].label, width(j), height(j)));
    }
  }
}

TEST_CASE("With two to eight states no label overlaps a state or another label") {
  for (std::uint32_t states = 2; states <= 8; ++states) {
    check_clear(ring(states));
    check_clear(star(states));
    if (states <= 4) check_clear(complete(states));
    if (states >= 4) check_clear(every(states));
  }
}

TEST_CASE("Arrows begin and end at the edges of their states, with both directions separate") {
  const view::Layout layout = view::lay_out(complete(3));
  const LayoutKey key = complete(3);
  for (std::size_t i = 0; i < layout.arrows.size(); ++i) {
    const view::ArrowPosition& arrow = layout.arrows[i];
    const auto at_edge = [&](view::Point point, view::Point middle) {
      const int x = std::abs(2 * std::abs(point.x - middle.x) - layout.box_width);
      const int y = std::abs(2 * std::abs(point.y - middle.y) - layout.box_height);
      return x <= 8 || y <= 8;
    };
    CHECK(at_edge(arrow.begin, layout.states[key.arrows[i].from]));
    CHECK(at_edge(arrow.end, layout.states[key.arrows[i].to]));
  }
}

TEST_CASE("One state, many states and very many arrows have a layout too") {
  CHECK(view::lay_out(LayoutKey{1, 4, {}}).width > 0);
  CHECK(view::lay_out(LayoutKey{0, 0, {}}).states.empty());
  CHECK(view::lay_out(ring(250)).states.size() == 250);
  CHECK(view::lay_out(complete(60)).arrows.size() == 60 * 59);
}

TEST_CASE("Devices of one structure share a layout, with any names") {
  const CompiledText plant = compile_rows(
      bits({"A_B_C_O_RUN", "A_B_C_I_RUN", "A_B_C_O_STOP", "X_YY_ZZ_O_MOV", "X_YY_ZZ_I_MOV", "X_YY_ZZ_O_HALT"}));
  const auto key = [&](std::size_t unit) {
    return view::layout_key(view::chart_of(plant.plant().units[unit], plant.plant()));
  };
  CHECK(key(0).arrows.size() == 2);
  CHECK((key(0) == key(1)));
  CHECK_FALSE((key(0) < key(1)));
}

}  // namespace
}  // namespace symplant::test
