// State charts for Mermaid.
#include "view/mermaid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diag/encode.hpp"
#include "elements/material/words.hpp"
#include "elements/requirement/words.hpp"
#include "view/chart.hpp"
#include "view/flow.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

constexpr std::string_view kMermaidHead =
    "%% A view, not the model: written by symplant, not read by it. Mermaid cannot express times other than as text,\n"
    "%% arrows between devices (the notes list disabled devices), that commands are levels and not edges, what a\n"
    "%% moving device does when commands change (the actuation), and the order of transitions that are ready.\n"
    "stateDiagram-v2\n  direction LR\n";

class MermaidWriter {
 public:
  explicit MermaidWriter(const Scene& scene) : scene_(scene), references_(cross_references(scene.plant)) {}

  std::string write() {
    text_ = kMermaidHead;
    for (const std::uint32_t unit : scene_.units) add_unit(unit);
    add_flow(flow_of(scene_));
    if (!scene_.plant.requirements.empty()) {
      text_ += "  state \"requirements\" as requirements\n";
      std::vector<std::string> lines;
      for (const model::Requirement& requirement : scene_.plant.requirements) {
        lines.push_back(requirement.name + ": " + requirement_text(requirement, scene_.plant));
      }
      add_note("requirements", lines);
    }
    if (const std::vector<std::string> lines = material_lines(scene_.plant); !lines.empty()) {
      text_ += "  state \"material\" as material\n";
      add_note("material", lines);
    }
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
    out("  state \"{}\" as u{} {{\n", diag::mermaid_text(unit.path), index);
    for (std::size_t s = 0; s < chart.states.size(); ++s) {
      const ChartState& state = chart.states[s];
      const bool rest = unit.actuation == tables::Actuation::spring && unit.rest == s;
      std::string content = state.name + (rest ? " (rest)" : "");
      if (!state.symbols.empty()) content += ": " + state.symbols;
      out("    state \"{}\" as u{}s{}\n", diag::mermaid_text(content), index, s);
    }
    out("    [*] --> u{}s{}\n", index, unit.initial);
    if (std::any_of(chart.edges.begin(), chart.edges.end(), [](const ChartEdge& e) { return e.from == kEveryOther; })) {
      out("    state \"every other state\" as u{}every\n", index);
    }
    for (const ChartEdge& edge : chart.edges) {
      const std::string from = edge.from == kEveryOther ? "every" : fmt::format("s{}", edge.from);
      std::string label;
      for (const std::string& line : edge.label) label.append(label.empty() ? "" : ", ").append(line);
      out("    u{0}{1} --> u{0}s{2} : {3}\n", index, from, edge.to, diag::mermaid_text(label));
    }
    text_ += "  }\n";
    add_note(fmt::format("u{}", index), facts_of(index, scene_.plant, references_));
  }

  /// Boxes are states, since a diagram has one type. The notes have the texts that boxes cut.
  void add_flow(const Flow& flow) {
    if (flow.empty()) return;
    text_ += "  state \"values\" as values {\n";
    for (std::size_t b = 0; b < flow.boxes.size(); ++b) {
      const std::vector<std::string>& lines = flow.boxes[b].lines;
      out("    state \"{}\" as f{}\n", diag::mermaid_text(lines.front()), b);
      for (std::size_t i = 1; i < lines.size(); ++i) out("    f{} : {}\n", b, diag::mermaid_text(lines[i]));
    }
    for (const FlowArrow& arrow : flow.arrows) {
      out("    f{} --> f{}{}\n", arrow.from, arrow.to, arrow.in_condition ? " : in a condition" : "");
    }
    for (std::size_t b = 0; b < flow.boxes.size(); ++b) {
      if (!flow.boxes[b].whole.empty()) add_note(fmt::format("f{}", b), flow.boxes[b].whole);
    }
    text_ += "  }\n";
  }

  void add_note(const std::string& of, const std::vector<std::string>& lines) {
    out("  note right of {}\n", of);
    for (const std::string& line : lines) out("    {}\n", diag::mermaid_text(line));
    text_ += "  end note\n";
  }

  const Scene& scene_;
  const CrossReferences references_;
  std::string text_;
};

}  // namespace

View mermaid_view(const Scene& scene) { return {base::whole(MermaidWriter(scene).write())}; }

}  // namespace symplant::view
