// State charts as a picture: by Graphviz, or by the built-in layout.
#include "view/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/process.hpp"
#include "diag/encode.hpp"
#include "elements/material/drawing.hpp"
#include "elements/requirement/words.hpp"
#include "view/chart.hpp"
#include "view/dot.hpp"
#include "view/flow_layout.hpp"
#include "view/layout.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using diag::markup_text;

constexpr int kMostWidth = 1600;  // of a row of cards
constexpr int kCardGap = 24;
constexpr int kTitleHeight = 24;

constexpr std::string_view kStyle =
    "<style>text{font:11px ui-monospace,Menlo,Consolas,monospace;fill:#1a1a1a}.title{font-size:14px;font-weight:bold}"
    ".card{fill:#fff;stroke:#bbb}.state{fill:#eef4fb;stroke:#345}.rest{stroke-width:3}.name{font-weight:bold}"
    ".way{fill:none;stroke:#345}.automatic{stroke-dasharray:5 3}.label{fill:#fff;fill-opacity:.85}.fact{fill:#444}"
    ".middle{text-anchor:middle}</style>\n";
constexpr std::string_view kLocationStyle =
    "<style>.belt{fill:#dfe5ec;stroke:#345}.other{fill:#cdd6e0}.part{fill:#c79a5b;stroke:#7a5a2a}.chevron{stroke:#345;"
    "stroke-width:2}"
    ".tick{stroke:#999;fill:#777}.leader{stroke:#aaa}.sensor{fill:#1769c5}.stop{fill:#c62828}.transfer{fill:#0e7c66}."
    "work{fill:#8a4fbf}"
    ".source{fill:#d17a00}text.tick{stroke:#fff;stroke-width:3;paint-order:stroke}</style>\n";
constexpr std::string_view kFlowStyle =
    "<style>.flow-value{fill:#eef4fb;stroke:#345}.flow-source{fill:#f2f2f2;stroke:#777}.flow-sink{fill:#fff4e0;"
    "stroke:#a66a00}</style>\n";
constexpr std::string_view kSvgHead =
    "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"8\" markerHeight=\"8\" "
    "orient=\"auto\"><path d=\"M0 0L8 4L0 8z\" fill=\"#345\"/></marker></defs>\n";
constexpr std::string_view kComment =
    "<!-- A view, not the model: written by symplant, not read by it. A chart cannot express that commands are levels\n"
    "     and not edges, what a moving device does when commands change (the actuation), that an automatic transition\n"
    "     disarms its command, the order of transitions that are ready, and the rounds of an instant. -->\n";

/// A card: its drawing, relative to its upper left corner, and its size.
struct Card {
  std::string content;
  int width = 0;
  int height = 0;
};

class CardWriter {
 public:
  /// A card with texts and no chart.
  CardWriter(const std::string& title, const std::vector<std::string>& lines) {
    add_title(title);
    add_lines(lines);
  }

  CardWriter(std::uint32_t index, const model::PlantModel& plant, const CrossReferences& references) {
    const model::Unit& unit = plant.units[index];
    const Chart chart = chart_of(unit, plant);
    const Layout layout = lay_out(layout_key(chart));
    add_title(std::string(unit.path));
    out("<g transform=\"translate(0 {})\">\n", card_.height);
    for (std::size_t i = 0; i < layout.arrows.size(); ++i) add_arrow(layout.arrows[i], chart.edges[i]);
    for (std::size_t i = 0; i < layout.arrows.size(); ++i) add_label(layout.arrows[i].label, chart.edges[i].label);
    for (std::size_t s = 0; s < layout.states.size(); ++s) {
      const bool rest = unit.actuation == tables::Actuation::spring && unit.rest == s;
      add_state(layout, layout.states[s], chart.states[s], rest, unit.initial == s);
    }
    card_.content += "</g>\n";
    card_.width = std::max(card_.width, layout.width);
    card_.height += layout.height;
    add_lines(facts_of(index, plant, references));
  }

  /// A track or place.
  explicit CardWriter(const Drawing& drawing) {
    add_title(drawing.title);
    out("<g transform=\"translate(0 {})\">\n", card_.height + 4);
    for (const Shape& shape : drawing.shapes) add_shape(shape);
    card_.content += "</g>\n";
    card_.width = std::max(card_.width, drawing.width);
    card_.height += drawing.height + kLineHeight;
  }

  /// The signal flow.
  explicit CardWriter(const Flow& flow) {
    add_title("values");
    const FlowLayout layout = lay_out(flow);
    out("<g transform=\"translate(0 {})\">\n", card_.height);
    for (const FlowLayout::Arrow& arrow : layout.arrows) {
      out("<path class=\"way{}\" d=\"{}\" marker-end=\"url(#head)\"/>\n",
          flow.arrows[arrow.arrow].in_condition ? " automatic" : "", path_text(arrow.points));
    }
    for (const FlowLayout::Box& box : layout.boxes) add_box(box, flow.boxes[box.box]);
    card_.content += "</g>\n";
    card_.width = std::max(card_.width, layout.width);
    card_.height += layout.height;
  }

  Card card() && { return std::move(card_); }

 private:
  template <class... Values>
  void out(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(card_.content), format, std::forward<Values>(values)...);
  }

  void add_title(const std::string& title) {
    out("<text class=\"title\" x=\"14\" y=\"20\">{}</text>\n", markup_text(title));
    card_.width = static_cast<int>(columns(title)) * 9 + 28;
    card_.height = kTitleHeight;
  }

  void add_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      card_.height += kLineHeight;
      out("<text class=\"fact\" x=\"14\" y=\"{}\">{}</text>\n", card_.height, markup_text(line));
      card_.width = std::max(card_.width, static_cast<int>(columns(line)) * kLetterWidth + 28);
    }
    card_.height += kLineHeight;
  }

  void add_shape(const Shape& shape) {
    switch (shape.kind) {
      case Shape::Kind::rect:
        out("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", shape.style, shape.x, shape.y,
            shape.a, shape.b);
        return;
      case Shape::Kind::line:
        out("<path class=\"{}\" d=\"M{} {}L{} {}\"/>\n", shape.style, shape.x, shape.y, shape.a, shape.b);
        return;
      case Shape::Kind::dot:
        out("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", shape.style, shape.x, shape.y, shape.a);
        return;
      case Shape::Kind::text:
        out("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", shape.style, shape.x, shape.y, markup_text(shape.text));
    }
  }

  void add_box(const FlowLayout::Box& at, const FlowBox& box) {
    out("<g>");
    for (std::size_t i = 0; i < box.whole.size(); ++i) {
      out("{}{}{}", i == 0 ? "<title>" : "\n", markup_text(box.whole[i]), i + 1 == box.whole.size() ? "</title>" : "");
    }
    out("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"/>\n", flow_class(box.kind), at.x,
        at.y, at.width, at.height, box.kind == FlowBox::Kind::value ? 2 : 12);
    int y = at.y + kFlowTextTop;
    for (const std::string& line : box.lines) {
      out("<text{} x=\"{}\" y=\"{}\">{}</text>\n", y == at.y + kFlowTextTop ? " class=\"name\"" : "",
          at.x + kFlowTextLeft, y, markup_text(line));
      y += kLineHeight;
    }
    out("</g>\n");
  }

  void add_arrow(const ArrowPosition& arrow, const ChartEdge& edge) {
    out("<path class=\"way{}\" d=\"M{} {}Q{} {} {} {}\" marker-end=\"url(#head)\"/>\n",
        edge.automatic ? " automatic" : "", arrow.begin.x, arrow.begin.y, arrow.control.x, arrow.control.y, arrow.end.x,
        arrow.end.y);
    if (edge.from == kEveryOther)
      out("<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"#345\"/>\n", arrow.begin.x, arrow.begin.y);
  }

  void add_label(Point middle, const std::vector<std::string>& lines) {
    std::uint32_t widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, columns(line));
    const int width = static_cast<int>(widest) * kLetterWidth;
    const int height = static_cast<int>(lines.size()) * kLineHeight;
    out("<rect class=\"label\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", middle.x - width / 2,
        middle.y - height / 2, width, height);
    int y = middle.y - height / 2 + 11;
    for (const std::string& line : lines) {
      out("<text class=\"middle\" x=\"{}\" y=\"{}\">{}</text>\n", middle.x, y, markup_text(line));
      y += kLineHeight;
    }
  }

  void add_state(const Layout& layout, Point middle, const ChartState& state, bool rest, bool initial) {
    const int left = middle.x - layout.box_width / 2;
    const int top = middle.y - layout.box_height / 2;
    if (initial) {
      out("<circle cx=\"{0}\" cy=\"{1}\" r=\"5\" fill=\"#345\"/><path class=\"way\" d=\"M{0} {1}V{2}\" "
          "marker-end=\"url(#head)\"/>\n",
          left + 14, top - 18, top);
    }
    out("<rect class=\"state{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"7\"/>\n", rest ? " rest" : "", left,
        top, layout.box_width, layout.box_height);
    out("<text class=\"middle name\" x=\"{}\" y=\"{}\">{}</text>\n", middle.x,
        middle.y + (state.symbols.empty() ? 4 : -3), markup_text(state.name));
    if (!state.symbols.empty()) {
      out("<text class=\"middle\" x=\"{}\" y=\"{}\">{}</text>\n", middle.x, middle.y + 12, markup_text(state.symbols));
    }
  }

  Card card_;
};

std::string own_picture(const Scene& scene, const Flow& flow) {
  const CrossReferences references = cross_references(scene.plant);
  std::vector<Card> cards;
  for (const std::uint32_t unit : scene.units) cards.push_back(CardWriter(unit, scene.plant, references).card());
  for (const std::uint32_t location : scene.locations) {
    cards.push_back(CardWriter(draw_location(scene.plant, location)).card());
  }
  if (!flow.empty()) cards.push_back(CardWriter(flow).card());
  if (!scene.units.empty() && !scene.plant.requirements.empty()) {
    std::vector<std::string> lines;
    for (const model::Requirement& requirement : scene.plant.requirements) {
      lines.push_back(requirement.name + ": " + requirement_text(requirement, scene.plant));
    }
    cards.push_back(CardWriter("requirements", lines).card());
  }
  std::string content;
  int x = kCardGap;
  int y = kCardGap;
  int row_height = 0;
  int width = 0;
  for (const Card& card : cards) {
    if (x > kCardGap && x + card.width > kMostWidth) {
      x = kCardGap;
      y += row_height + kCardGap;
      row_height = 0;
    }
    fmt::format_to(
        std::back_inserter(content),
        "<g transform=\"translate({} {})\">\n<rect class=\"card\" width=\"{}\" height=\"{}\" rx=\"4\"/>\n{}</g>\n", x,
        y, card.width, card.height, card.content);
    x += card.width + kCardGap;
    width = std::max(width, x);
    row_height = std::max(row_height, card.height);
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n{2}<title>{3}"
      "</title>\n{4}{5}{6}{7}<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n{8}</svg>\n",
      width, y + row_height + kCardGap, kComment, markup_text(scene.plant.name), kStyle,
      scene.locations.empty() ? std::string_view() : kLocationStyle, flow.empty() ? std::string_view() : kFlowStyle,
      kSvgHead, content);
}

}  // namespace

View svg_view(const Scene& scene) {
  const Flow flow = flow_of(scene);
  std::string decision = "the picture is laid out by symplant itself";
  if (!scene.locations.empty()) {
    decision += ", since Graphviz does not draw tracks";
  } else if (!flow.empty()) {
    decision += ", since it places the values between the inputs and outputs of the plant";
  } else if (scene.programs != nullptr) {
    const std::string dot = base::text_of(dot_view(scene).text);
    auto drawn = scene.programs->run({"dot", {"-Tsvg"}, dot});
    if (drawn && drawn->find("<svg") != std::string::npos) {
      return {base::whole(std::move(*drawn)), {"the picture is laid out by Graphviz"}};
    }
    decision += drawn ? ", since `dot` gave no picture" : ", since " + drawn.error().message;
  }
  return {base::whole(own_picture(scene, flow)), {std::move(decision)}};
}

}  // namespace symplant::view
