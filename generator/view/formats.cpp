// The table of view formats.
#include "view/formats.hpp"

#include <algorithm>
#include <array>

#include "view/dot.hpp"
#include "view/html.hpp"
#include "view/mermaid.hpp"
#include "view/model_json.hpp"
#include "view/model_table.hpp"
#include "view/scxml.hpp"
#include "view/svg.hpp"

namespace symplant::view {
namespace {

constexpr std::array kFormats{
    Format{"table", "for people, in a terminal", &model_table},
    Format{"json", "for programs, with a schema", &model_json},
    Format{"html", "one page for a browser", &html_view},
    Format{"dot", "state charts for Graphviz", &dot_view},
    Format{"svg", "state charts as a picture", &svg_view},
    Format{"mermaid", "state charts for Markdown pages", &mermaid_view},
    Format{"scxml", "state charts for SCXML tools", &scxml_view},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* find_format(std::string_view name) {
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) { return format.name == name; });
  return found == kFormats.end() ? nullptr : found;
}

}  // namespace symplant::view
