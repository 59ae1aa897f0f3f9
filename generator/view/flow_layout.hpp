// The built-in layout of the signal flow: coordinates of its boxes and arrows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "view/flow.hpp"
#include "view/layout.hpp"

namespace symplant::view {

struct FlowLayout {
  struct Box {
    std::uint32_t box = 0;  ///< index in Flow::boxes; a source has a box in each part that reads it
    int x = 0;              ///< of the upper left corner
    int y = 0;
    int width = 0;
    int height = 0;
  };
  struct Arrow {
    std::uint32_t arrow = 0;    ///< index in Flow::arrows
    std::uint32_t from = 0;     ///< index in `boxes`
    std::uint32_t to = 0;       ///< index in `boxes`
    std::vector<Point> points;  ///< where it begins, then two control points and an end for each cubic Bezier curve
  };
  int width = 0;
  int height = 0;
  std::vector<Box> boxes;
  std::vector<Arrow> arrows;
};

inline constexpr int kFlowTextTop = 16;   ///< from the top of a box to the base line of its first text
inline constexpr int kFlowTextLeft = 10;  ///< from the left of a box to its texts

/// Places boxes in layers from left to right, so that arrows lead to the right except those that close a circle, which
/// return below boxes. No box touches another box, and no arrow another box than its own. Parts that nothing joins lie
/// next to each other. The result is the same on every machine. O((boxes + arrows) * layers), and it forgets that
/// arrows avoid boxes if that is too much.
FlowLayout lay_out(const Flow& flow);

/// The path of an arrow for SVG: `M1 2C3 4 5 6 7 8`.
std::string path_text(const std::vector<Point>& points);

}  // namespace symplant::view
