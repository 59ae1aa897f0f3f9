// Drawings and lists of the material flow for the page.
#include "elements/material/html.hpp"

#include <optional>
#include <string>

#include "diag/visible_text.hpp"
#include "elements/material/drawing.hpp"
#include "elements/material/words.hpp"
#include "view/words.hpp"

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

void write_drawing(const std::string& name, const Drawing& drawing, JsonWriter& json) {
  json.begin_object();
  json.member("name", visible(name));
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
  json.array(scene.locations, [&](std::uint32_t location) {
    write_drawing(material.location_name(location), draw_location(scene.plant, location), json);
  });
  json.key("kinds");
  json.array(material.kinds, [&](const model::PartKind& kind) { json.value(visible(words.kind(kind))); });
  const auto when = [&](const std::optional<condition::Tree>& tree) {
    return tree ? visible(words.condition(*tree)) : std::string();
  };
  json.key("transfers");
  json.array(material.transfers, [&](const model::Transfer& transfer) {
    json.row(visible(transfer.name), visible(words.location(transfer.from)), visible(words.location(transfer.to)),
             when(transfer.condition), transfer.once ? "once" : "");
  });
  json.key("work");
  json.array(material.work, [&](const model::Work& work) {
    json.row(visible(work.name), visible(words.location(work.at)), visible(material.kinds[work.from].name),
             visible(material.kinds[work.to].name), visible(words.condition(work.condition)));
  });
  json.key("sources");
  json.array(material.sources, [&](const model::Source& source) {
    json.row(visible(source.name), visible(words.location(source.to)), visible(words.kinds(source.kinds)),
             duration_text(description::Duration::fixed(source.first)),
             source.every ? duration_text(*source.every) : std::string(), when(source.condition),
             source.count ? std::to_string(*source.count) : std::string());
  });
  json.end_object();
}

}  // namespace symplant::view
