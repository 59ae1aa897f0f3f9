// A track to scale with its marks, or a place, as simple shapes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// Sizes in pixels; y grows downward.
struct Shape {
  enum class Kind : std::uint8_t {
    rect,  ///< x, y: its upper left corner; a, b: width and height
    line,  ///< from x, y to a, b
    dot,   ///< x, y: its middle; a: its radius
    text,  ///< x, y: where its base line begins
  };
  Kind kind = Kind::rect;
  std::string_view style;  ///< class of the style sheets of SVG and page
  int x = 0;
  int y = 0;
  int a = 0;
  int b = 0;
  std::string text = {};
};

struct Drawing {
  std::string title;
  std::vector<Shape> shapes;
  int width = 0;
  int height = 0;
};

/// `location`: a track, or a place after all tracks, as in tables::MaterialTables. O(material).
Drawing draw_location(const model::PlantModel& plant, std::uint32_t location);

}  // namespace symplant::view
