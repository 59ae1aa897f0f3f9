// Types of PLCopen XML as text.
#include "read/xml/plcopen_type.hpp"

#include "text/ascii.hpp"

namespace symplant::read::xml {

namespace {

constexpr int kMostLevels = 64;

std::string array_head(const Element& array) {
  std::string dimensions;
  for (Element dimension = array.first_child(); dimension; dimension = dimension.next_sibling()) {
    if (dimension.name() != "dimension") continue;
    dimensions.append(dimensions.empty() ? "" : ", ").append(dimension.attribute("lower").text);
    dimensions.append("..").append(dimension.attribute("upper").text);
  }
  return "ARRAY [" + dimensions + "] OF ";
}

std::string simple_type(const Element& type) {
  if (type.name() == "derived") return std::string(type.attribute("name").text);
  std::string text = text::to_upper(type.name());
  const std::string_view length = type.attribute("length").text;
  return length.empty() ? text : text.append("(").append(length).append(")");
}

}  // namespace

std::string plcopen_type(Element type) {
  std::string text;
  for (int level = 0; level < kMostLevels; ++level) {
    const Element inner = type.first_child();
    if (!inner) return text;
    const std::string_view name = inner.name();
    if (name == "array") {
      text += array_head(inner);
    } else if (name == "pointer") {
      text += "POINTER TO ";
    } else if (name == "reference") {
      text += "REFERENCE TO ";
    } else if (!name.starts_with("subrange")) {
      return text + simple_type(inner);
    }
    type = inner.child("baseType");
  }
  return text;
}

}  // namespace symplant::read::xml
