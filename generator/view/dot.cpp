// State charts for Graphviz.
#include "view/dot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diag/encode.hpp"
#include "elements/material/words.hpp"
#include "elements/requirement/words.hpp"
#include "model/plant_model.hpp"
#include "view/chart.hpp"
#include "view/flow.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

constexpr std::string_view kDotHead =
    "// A view, not the model: written by symplant, not read by it. A Graphviz chart cannot express that commands are\n"
    "// levels and not edges, what a moving device does when commands change (the actuation), that an automatic\n"
    "// transition disarms its command, the order of transitions that are ready, and the rounds of an instant.\n";

constexpr std::string_view kAttributes =
    "  graph [rankdir=LR, compound=true, fontname=\"Helvetica\", fontsize=12, nodesep=0.5, ranksep=0.8]\n"
    "  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11, margin=\"0.15,0.08\"]\n"
    "  edge [fontname=\"Helvetica\", fontsize=10, arrowsize=0.7]\n";

class DotWriter {
 public:
  explicit DotWriter(const Scene& scene) : scene_(scene), references_(cross_references(scene.plant)) {}

  std::string write() {
    text_ = kDotHead;
    out("digraph {} {{\n", diag::dot_string(scene_.plant.name));
    text_ += kAttributes;
    for (const std::uint32_t unit : scene_.units) add_unit(unit);
    for (const std::uint32_t unit : scene_.units) add_disables(unit);
    add_flow(flow_of(scene_));
    add_requirements();
    add_material();
    text_ += "}\n";
    return std::move(text_);
  }

 private:
  template <class... Values>
  void out(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  void add_unit(std::uint32_t index) {
    const model::Unit& unit = scene_.plant.units[index];
    const Chart chart = chart_of(unit, scene_.plant);
    out("\n  subgraph cluster_{} {{\n    label={}\n", index, diag::dot_string(unit.path));
    for (std::size_t s = 0; s < chart.states.size(); ++s) {
      const ChartState& state = chart.states[s];
      const bool rest = unit.actuation == tables::Actuation::spring && unit.rest == s;
      out("    u{}_s{} [label=\"{}", index, s, diag::dot_text(state.name));
      if (rest) text_ += "\\n(rest)";
      if (!state.symbols.empty()) text_.append("\\n").append(diag::dot_text(state.symbols));
      text_ += "\"]\n";
    }
    out("    u{0}_start [shape=point, width=0.12, label=\"\"]\n    u{0}_start -> u{0}_s{1}\n", index, unit.initial);
    if (std::any_of(chart.edges.begin(), chart.edges.end(), [](const ChartEdge& e) { return e.from == kEveryOther; })) {
      out("    u{}_every [shape=plaintext, label=\"every other state\"]\n", index);
    }
    for (const ChartEdge& edge : chart.edges) add_edge(index, edge);
    out("    u{}_facts [shape=note, style=\"\", fontsize=9, label=\"", index);
    for (const std::string& fact : facts_of(index, scene_.plant, references_)) {
      text_.append(diag::dot_text(fact)).append("\\l");
    }
    text_ += "\"]\n  }\n";
  }

  void add_edge(std::uint32_t index, const ChartEdge& edge) {
    const std::string from = edge.from == kEveryOther ? "every" : fmt::format("s{}", edge.from);
    out("    u{0}_{1} -> u{0}_s{2} [label=\"", index, from, edge.to);
    for (std::size_t i = 0; i < edge.label.size(); ++i) {
      text_.append(i == 0 ? "" : "\\n").append(diag::dot_text(edge.label[i]));
    }
    text_ += edge.automatic ? "\", style=dashed]\n" : "\"]\n";
  }

  void add_disables(std::uint32_t index) {
    const auto& disables = scene_.plant.units[index].disables;
    for (std::size_t s = 0; s < disables.size(); ++s) {
      for (const std::uint32_t other : disables[s]) {
        if (!std::binary_search(scene_.units.begin(), scene_.units.end(), other)) continue;
        out("  u{}_s{} -> u{}_s0 [lhead=cluster_{}, label=\"disables\", style=dotted, constraint=false]\n", index, s,
            other, other);
      }
    }
  }

  void add_flow(const Flow& flow) {
    if (flow.empty()) return;
    text_ += "\n  subgraph cluster_values {\n    label=\"values\"\n";
    for (std::size_t b = 0; b < flow.boxes.size(); ++b) {
      const FlowBox& box = flow.boxes[b];
      out("    f{} [label=\"", b);
      for (const std::string& line : box.lines) text_.append(diag::dot_text(line)).append("\\l");
      out("\"{}", box.kind == FlowBox::Kind::value ? ", style=\"\"" : ", color=gray40");
      for (std::size_t i = 0; i < box.whole.size(); ++i) {
        text_.append(i == 0 ? ", tooltip=\"" : "\\n").append(diag::dot_text(box.whole[i]));
      }
      text_ += box.whole.empty() ? "]\n" : "\"]\n";
    }
    for (const FlowArrow& arrow : flow.arrows) {
      out("    f{} -> f{}{}\n", arrow.from, arrow.to, arrow.in_condition ? " [style=dashed]" : "");
    }
    text_ += "  }\n";
  }

  void add_requirements() {
    if (scene_.plant.requirements.empty()) return;
    text_ += "\n  requirements [shape=note, style=\"\", fontsize=9, label=\"requirements\\l";
    for (const model::Requirement& requirement : scene_.plant.requirements) {
      text_.append(diag::dot_text(requirement.name + ": " + requirement_text(requirement, scene_.plant))).append("\\l");
    }
    text_ += "\"]\n";
  }

  void add_material() {
    const std::vector<std::string> lines = material_lines(scene_.plant);
    if (lines.empty()) return;
    text_ += "\n  material [shape=note, style=\"\", fontsize=9, label=\"material\\l";
    for (const std::string& each : lines) text_.append(diag::dot_text(each)).append("\\l");
    text_ += "\"]\n";
  }

  const Scene& scene_;
  const CrossReferences references_;
  std::string text_;
};

}  // namespace

View dot_view(const Scene& scene) { return {base::whole(DotWriter(scene).write())}; }

}  // namespace symplant::view
