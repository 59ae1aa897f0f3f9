// Drawings: Graphviz and XML readers accept them, and every name stays in its element.
#include <map>

#include "base/process.hpp"
#include "flow_support.hpp"

namespace symplant::test {
namespace {

using base::ProcessCall;
using base::ProcessError;

/// Records its requests; answers as set up.
class FakeRunner final : public base::ProcessRunner {
 public:
  explicit FakeRunner(base::Result<std::string, ProcessError> answer) : answer_(std::move(answer)) {}
  base::Result<std::string, ProcessError> run(const ProcessCall& call) override {
    program = call.program;
    arguments = call.arguments;
    input = std::string(call.input);
    return answer_;
  }

  std::string program;
  std::vector<std::string> arguments;
  std::string input;

 private:
  base::Result<std::string, ProcessError> answer_;
};

bool installed(const std::string& program, std::vector<std::string> arguments) {
  base::SystemProcessRunner runner;
  if (runner.run({program, std::move(arguments)})) return true;
  WARN(program << " is not installed");
  return false;
}

bool has_xml_reader() {
  static const bool has_python = installed("python3", {"-c", "import xml.dom.minidom"});
  return has_python;
}

/// Whether an XML reader accepts a text; yes if there is no reader.
bool is_xml(const std::string& text) {
  if (!has_xml_reader()) return true;
  base::SystemProcessRunner runner;
  return static_cast<bool>(
      runner.run({"python3", {"-c", "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.stdin)"}, text}));
}

TEST_CASE("SVG comes from Graphviz if it works, with a message") {
  FakeRunner runner(std::string("<svg>by Graphviz</svg>"));
  const CompiledText cell = described_cell();
  const Rendered view = render(cell, "svg", &runner);
  CHECK(view.text == "<svg>by Graphviz</svg>");
  CHECK(view.decisions == std::vector<std::string>{"the picture is laid out by Graphviz"});
  CHECK(runner.program == "dot");
  CHECK(runner.arguments == std::vector<std::string>{"-Tsvg"});
  CHECK(runner.input == render(cell, "dot").text);
}

TEST_CASE("symplant draws SVG itself if Graphviz is missing, fails or gives no picture") {
  const CompiledText cell = described_cell();
  const std::string own = render(cell, "svg").text;
  FakeRunner absent(ProcessError{ProcessError::Kind::absent, "`dot` is not on the path"});
  const Rendered view = render(cell, "svg", &absent);
  CHECK(view.text == own);
  CHECK(view.decisions ==
        std::vector<std::string>{"the picture is laid out by symplant itself, since `dot` is not on the path"});
  FakeRunner mute{std::string()};
  CHECK(render(cell, "svg", &mute).text == own);
}

TEST_CASE("Graphviz accepts its input, including hostile names") {
  if (!installed("dot", {"-V"})) return;
  base::SystemProcessRunner runner;
  for (const CompiledText& plant : {described_cell(), hostile_cell(), tank_with_values(), hostile_values()}) {
    const std::string dot = render(plant, "dot").text;
    const auto svg = runner.run({"dot", {"-Tsvg"}, dot});
    REQUIRE(svg);
    CHECK(is_xml(*svg));
    CHECK_FALSE(contains(*svg, "<img"));
    CHECK_FALSE(contains(*svg, "<script"));
  }
}

TEST_CASE("SVG and SCXML are valid XML, including hostile names") {
  if (has_xml_reader()) CHECK_FALSE(is_xml("<a><b></a>"));
  for (const char* format : {"svg", "scxml"}) {
    INFO(format);
    for (const CompiledText& plant :
         {described_cell(), hostile_cell(), tank_with_values(), hostile_values(), compile_rows({{"START", "X1"}})}) {
      const std::string text = render(plant, format).text;
      CHECK(is_xml(text));
      CHECK_FALSE(contains(text, "<img"));
      CHECK_FALSE(contains(text, "<script"));
      CHECK_FALSE(contains(text, "\xE2\x80\xAE"));
    }
  }
}

TEST_CASE("In Mermaid a hostile name stays in its line and its quotes") {
  const std::string text = render(hostile_cell(), "mermaid").text;
  CHECK_FALSE(contains(text, "<"));
  CHECK(contains(text, "#60;/script#62;"));
  CHECK_FALSE(contains(text, "%%\n"));
}

TEST_CASE("One arrow replaces those of all states with the same transition") {
  const CompiledText cell = described_cell();
  const view::Chart chart = view::chart_of(cell.plant().units[4], cell.plant());
  REQUIRE(chart.edges.size() == 6);
  for (const view::ChartEdge& edge : chart.edges) CHECK(edge.from == view::kEveryOther);
  const std::string dot = render(cell, "dot").text;
  CHECK(contains(dot, "u4_every -> u4_s0 [label=\"O_A1, takes 1 s\"]"));
}

TEST_CASE("A chart shows commanded and automatic transitions, conditions and times") {
  const CompiledText cell = described_cell();
  const std::string dot = render(cell, "dot").text;
  for (const char* part : {
           "u0_s0 -> u0_s1 [label=\"O_P2, takes 2 s, given\\nO_CHARGE, [c1], takes 1 s\\ngiven\"]",
           "u0_s1 -> u0_s2 [label=\"O_CHARGE, once\\ntakes 4 s (sigma 100 ms)\\ngiven\"]",
           "u1_s1 -> u1_s0 [label=\"by itself, after 5 s\\ngiven\", style=dashed]",
           "c1: not (L_P_MC.RUN2 or L_Q_DOOR.OPEN1) and LEVEL < 2.5\\l",
           "u1_s1 -> u0_s0 [lhead=cluster_0, label=\"disables\"",
           "(rest)",
           "machine starts: after L_P_AGV.P2, expect L_P_MC_O_RUN2 within 500 ms\\l",
       }) {
    INFO(part);
    CHECK(contains(dot, part));
  }
}

TEST_CASE("A chart shows a spring return, also without a description") {
  const CompiledText cylinder = compile_rows(bits({"L_P_C_O_ADV", "L_P_C_I_ADV", "L_P_C_I_RET"}));
  CHECK(contains(render(cylinder, "dot").text, "u0_s0 -> u0_s1 [label=\"spring, takes 1 s\"]"));
  CHECK(contains(render(cylinder, "scxml").text, "<symplant:spring-way from=\"ADV\" to=\"RET\" takes=\"1 s\"/>"));
}

TEST_CASE("SCXML has conditions as expressions, delays as sends, and the rest in a separate namespace") {
  const std::string with_parts = render(cell_with_parts(), "scxml").text;
  CHECK(contains(with_parts, "parts_P &gt;= 1"));
  CHECK(contains(with_parts, "parts_P_raw &gt;= 1"));
  const std::string scxml = render(described_cell(), "scxml").text;
  for (const char* part : {
           "cond=\"!(In(&#39;L_P_MC.RUN2&#39;) || In(&#39;L_Q_DOOR.OPEN1&#39;)) &amp;&amp; value_LEVEL &lt; 2.5\"",
           "<data id=\"value_LEVEL\" expr=\"0\"/>",
           "<send id=\"after.L_P_MC.1\" event=\"after.L_P_MC.1\" delay=\"5s\"/>",
           "<cancel sendid=\"after.L_P_MC.1\"/>",
           "<transition event=\"after.L_P_MC.1\" target=\"L_P_MC.IDLE1\"",
           "<symplant:disables device=\"L_P_AGV\"/>",
           "<symplant:disabled-by device=\"L_P_MC\" state=\"RUN2\"/>",
           "<symplant:spring-way from=\"ADV\" to=\"RET\" takes=\"800 ms\"/>",
           "symplant:takes=\"4 s (sigma 100 ms)\"",
       }) {
    INFO(part);
    CHECK(contains(scxml, part));
  }
}

}  // namespace
}  // namespace symplant::test
