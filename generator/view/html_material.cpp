// Drawings and lists of the material flow for the page.
#include "view/html_material.hpp"

#include "diag/visible_text.hpp"
#include "view/location_drawing.hpp"
#include "view/material_words.hpp"

namespace symplant::view {
namespace {

using diag::visible;

/// The elements are in the order that drawShape() of page.js expects.
void write_shape(const Shape& shape, JsonWriter& json) {
  switch (shape.kind) {
    case Shape::Kind::rect:
      return json.row("rect", shape.style, shape.x, shape.y, shape.a, shape.b);
    case Shape::Kind::line:
      return json.row("line", shape.style, shape.x, shape.y, shape.a, shape.b);
    case Shape::Kind::dot:
      return json.row("dot", shape.style, shape.x, shape.y, shape.a);
    case Shape::Kind::text:
      return json.row("text", shape.style, shape.x, shape.y, visible(shape.text));
  }
}

void write_drawing(const Drawing& drawing, JsonWriter& json) {
  json.begin_object();
  json.member("title", visible(drawing.title));
  json.member("width", drawing.width);
  json.member("height", drawing.height);
  json.key("shapes");
  json.array(drawing.shapes, [&](const Shape& shape) { write_shape(shape, json); });
  json.end_object();
}

}  // namespace

void write_page_material(const Scene& scene, JsonWriter& json) {
  const model::Material& material = scene.plant.material;
  if (material.empty()) return;
  const MaterialWords words(scene.plant);
  json.key("material");
  json.begin_object();
  json.key("locations");
  json.array(scene.locations,
             [&](std::uint32_t location) { write_drawing(draw_location(scene.plant, location), json); });
  json.key("kinds");
  json.array(material.kinds, [&](const model::PartKind& kind) { json.value(visible(words.kind(kind))); });
  json.key("transfers");
  json.array(material.transfers,
             [&](const model::Transfer& transfer) { json.value(visible(words.transfer(transfer))); });
  json.key("work");
  json.array(material.work, [&](const model::Work& work) { json.value(visible(words.work(work))); });
  json.key("sources");
  json.array(material.sources, [&](const model::Source& source) { json.value(visible(words.source(source))); });
  json.end_object();
}

}  // namespace symplant::view
