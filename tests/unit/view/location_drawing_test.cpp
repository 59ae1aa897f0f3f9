// Tests of the drawings of tracks and places: everything is drawn to scale, and no text is covered.
#include <algorithm>

#include "elements/material/drawing.hpp"
#include "view/layout.hpp"
#include "view_support.hpp"

namespace symplant::test {
namespace {

using view::Drawing;
using view::Shape;

const Shape& text_shape(const Drawing& drawing, const std::string& begin) {
  const auto found = std::find_if(drawing.shapes.begin(), drawing.shapes.end(), [&](const Shape& shape) {
    return shape.kind == Shape::Kind::text && shape.text.rfind(begin, 0) == 0;
  });
  REQUIRE(found != drawing.shapes.end());
  return *found;
}

/// A track with `count` sensors, one each 100 mm.
CompiledText track_of_sensors(std::size_t count) {
  description::Description given;
  given.material.kinds = {{"box", 100'000, 0}};
  description::GivenTrack track;
  track.name = "CV";
  track.length = static_cast<std::int64_t>(count + 1) * 100'000;
  track.drives = {{{}, "L_P_CV_O_RUN", "", {400'000, ""}}};
  std::vector<Row> rows{{"L_P_CV_O_RUN", "Y1"}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "L_P_PE" + std::to_string(i) + "_I_ON";
    rows.push_back({name});
    track.sensors.push_back({name, static_cast<std::int64_t>(i + 1) * 100'000, {}, false, tables::SensorReads::part});
  }
  given.material.tracks = {track};
  CompiledText made = compile_described(rows, given);
  REQUIRE(made.compiled);
  return made;
}

TEST_CASE("A mark is drawn at its position, to scale") {
  const Drawing drawing = view::draw_location(plant_with_material().plant(), 0);
  CHECK(drawing.title == "CV1: 2 m, gap 10 mm");
  const int begin = text_shape(drawing, "0 mm").x;
  const int end = text_shape(drawing, "2 m").x;
  CHECK(end - begin == 720);
  CHECK(text_shape(drawing, "1 m").x - begin == 360);
  // A flag's text begins 4 after its position, a tick's text 2.
  CHECK(text_shape(drawing, "L_P_PE_I_ON").x - begin == 720 * 300 / 2000 + 2);
  CHECK(text_shape(drawing, "stop when").x - begin == 720 * 500 / 2000 + 2);
  CHECK(text_shape(drawing, "transfer pick").x - begin == 720 / 2 + 2);
  CHECK(text_shape(drawing, "source feed").x - begin == 2);
  CHECK(text_shape(drawing, "to FIX").x - begin == 720 + 2);
  const auto part = std::find_if(drawing.shapes.begin(), drawing.shapes.end(),
                                 [](const Shape& shape) { return shape.style == "part"; });
  REQUIRE(part != drawing.shapes.end());
  CHECK(part->a == 72);  // 200 mm of 2 m
}

TEST_CASE("No text of a track is covered by another text or crossed by a line") {
  for (const std::size_t count : {1U, 5U, 40U, 120U}) {
    const CompiledText plant = track_of_sensors(count);
    const Drawing drawing = view::draw_location(plant.plant(), 0);
    std::size_t sensors = 0;
    for (const Shape& text : drawing.shapes) {
      if (text.kind != Shape::Kind::text || text.style != "fact start") continue;
      sensors += text.text.rfind("L_P_PE", 0) == 0 ? 1U : 0U;
      const int end = text.x + static_cast<int>(view::columns(text.text)) * view::kLetterWidth;
      CHECK(end <= drawing.width);
      CHECK(text.y <= drawing.height);
      for (const Shape& other : drawing.shapes) {
        INFO(text.text << " and " << other.text << " at " << other.x);
        if (other.kind == Shape::Kind::text && &other != &text && other.y == text.y) {
          CHECK((other.x >= end || other.x < text.x));
        }
        if (other.style == "leader" && other.x > text.x && other.x < end) {
          CHECK((std::max(other.y, other.b) <= text.y - 8 || std::min(other.y, other.b) >= text.y));
        }
      }
    }
    CHECK(sensors == count);
  }
}

TEST_CASE("The ends of a track are read from the top, as in the description") {
  const Drawing drawing = view::draw_location(plant_with_material().plant(), 0);
  CHECK(text_shape(drawing, "to FIX").y < text_shape(drawing, "to out").y);
}

TEST_CASE("Kinds that are not drawn are counted") {
  description::Description given;
  for (int k = 0; k < 8; ++k) given.material.kinds.push_back({"k" + std::to_string(k), 100'000, 0});
  description::GivenTrack track;
  track.name = "CV";
  track.length = 1'000'000;
  track.drives = {{{}, "L_P_CV_O_RUN", "", {400'000, ""}}};
  given.material.tracks = {track};
  const CompiledText made = compile_described({{"L_P_CV_O_RUN", "Y1"}}, given);
  REQUIRE(made.compiled);
  const Drawing drawing = view::draw_location(made.plant(), 0);
  text_shape(drawing, "k5: 100 mm");
  text_shape(drawing, "2 other kinds");
}

TEST_CASE("A place shows its slots, its sensors and what others do there") {
  const Drawing drawing = view::draw_location(plant_with_material().plant(), 1);
  CHECK(drawing.title == "FIX: holds 2");
  CHECK(std::count_if(drawing.shapes.begin(), drawing.shapes.end(),
                      [](const Shape& shape) { return shape.style == "belt"; }) == 2);
  text_shape(drawing, "L_P_NR_I_CODE, reads the number");
  text_shape(drawing, "from CV1, when L_P_CV.RUN");
  text_shape(drawing, "work mill: raw to done at FIX");
}

}  // namespace
}  // namespace symplant::test
