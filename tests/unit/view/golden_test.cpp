// Every format, for a plant that uses every feature of descriptions.
#include "view_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Each view of the described cell equals its golden") {
  const CompiledText cell = described_cell();
  check_view_golden(cell, "table", "cell.txt");
  check_view_golden(cell, "json", "cell.json");
  check_view_golden(cell, "dot", "cell.dot");
  check_view_golden(cell, "mermaid", "cell.mmd");
  check_view_golden(cell, "scxml", "cell.scxml");
  check_view_golden(cell, "svg", "cell.svg");
}

TEST_CASE("Views with a material flow equal their goldens") {
  const CompiledText plant = plant_with_material();
  check_view_golden(plant, "json", "material.json");
  check_view_golden(plant, "svg", "material.svg");
  check_view_golden(plant, "dot", "material.dot");
  check_view_golden(plant, "mermaid", "material.mmd");
  check_view_golden(plant, "scxml", "material.scxml");
}

TEST_CASE("A view is the same each time") {
  for (const view::Format& format : view::formats()) {
    INFO(format.name);
    CHECK(render(described_cell(), format.name).text == render(described_cell(), format.name).text);
  }
}

TEST_CASE("A view of no device is a valid file") {
  const CompiledText none = compile_rows({{"START", "X1"}});
  for (const view::Format& format : view::formats()) {
    INFO(format.name);
    CHECK_FALSE(render(none, format.name).text.empty());
  }
}

}  // namespace
}  // namespace symplant::test
