// Cells of a table from texts of an XML file.
#pragma once

#include <string>

#include "read/cells/one_line.hpp"
#include "read/xml/document.hpp"

namespace symplant::read::xml {

inline std::string_view cell(TableBuilder& builder, const Text& text) {
  return one_line(builder, text.offset, text.text);
}

/// An attribute on one line; empty if it is absent.
inline std::string_view attribute_cell(TableBuilder& builder, const Element& element, const char* name) {
  return cell(builder, element.attribute(name));
}

/// The text in an element on one line.
inline std::string_view content_cell(TableBuilder& builder, const Element& element) {
  std::string joined;
  return cell(builder, element.content(joined));
}

}  // namespace symplant::read::xml
