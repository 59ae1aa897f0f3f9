// The built-in layout: coordinates of the states and arrows of a chart.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "view/chart.hpp"

namespace symplant::view {

/// Size of a letter in pixels, in a monospaced font.
inline constexpr int kLetterWidth = 7;
inline constexpr int kLineHeight = 14;

/// The input of a layout: no texts, only their rounded sizes, so that devices of equal structure share a layout.
struct LayoutKey {
  struct Arrow {
    std::uint32_t from;  ///< kEveryOther: from every other state
    std::uint32_t to;
    std::uint32_t lines;
    std::uint32_t columns;  ///< of the longest line
    friend bool operator==(const Arrow&, const Arrow&) = default;
    friend bool operator<(const Arrow& a, const Arrow& b) {
      return std::tie(a.from, a.to, a.lines, a.columns) < std::tie(b.from, b.to, b.lines, b.columns);
    }
  };
  std::uint32_t states = 0;
  std::uint32_t columns = 0;  ///< of the longest name
  std::vector<Arrow> arrows;  ///< in the order of Chart::edges
  friend bool operator==(const LayoutKey&, const LayoutKey&) = default;
  friend bool operator<(const LayoutKey& a, const LayoutKey& b) {
    return std::tie(a.states, a.columns, a.arrows) < std::tie(b.states, b.columns, b.arrows);
  }
};

/// Columns that a text takes in a monospaced font, with unsafe characters escaped. O(text).
std::uint32_t columns(const std::string& text);

/// The key of a chart. Columns are rounded up, so that names of nearly equal length share a layout.
LayoutKey layout_key(const Chart& chart);

struct Point {
  int x = 0;
  int y = 0;
};

/// A quadratic Bezier curve from `begin` to `end`, and the center of its label.
struct ArrowPosition {
  Point begin;
  Point control;
  Point end;
  Point label;
};

struct Layout {
  int width = 0;
  int height = 0;
  int box_width = 0;
  int box_height = 0;
  std::vector<Point> states;          ///< the center of each box
  std::vector<ArrowPosition> arrows;  ///< in the order of the key
};

/// Places states on an ellipse, the first on top (two states: in a row). Arrows are bent, so that opposite ones differ.
/// The ellipse grows until labels cover neither states nor each other. The result is the same on every machine.
/// O(arrows^2); with more than 400 arrows O(arrows), and labels may overlap.
Layout lay_out(const LayoutKey& key);

}  // namespace symplant::view
