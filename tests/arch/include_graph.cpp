// The include graph of the sources: circles of units, and the chart of layers.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "arch/arch_rules.hpp"

namespace symplant::arch {
namespace {

namespace fs = std::filesystem;

using Graph = std::map<std::string, std::set<std::string>>;

/// `#include "..."` of a text, in order.
std::vector<std::string> quoted_includes(std::string_view text) {
  constexpr std::string_view kInclude = "#include \"";
  std::vector<std::string> found;
  for (std::size_t at = text.find(kInclude); at != text.npos; at = text.find(kInclude, at + 1)) {
    const std::size_t begin = at + kInclude.size();
    found.emplace_back(text.substr(begin, text.find('"', begin) - begin));
  }
  return found;
}

std::string without_extension(const std::string& path) { return fs::path(path).replace_extension().generic_string(); }

/// From the root of the project.
std::string path_of_include(const std::string& include) {
  constexpr std::string_view kPrefix = "symplant/";
  return include.starts_with(kPrefix) ? "runtime/" + include.substr(kPrefix.size()) : "generator/" + include;
}

template <class NodeOf>
Graph graph_of(const Tree& tree, NodeOf&& node_of) {
  Graph graph;
  for (const File& file : tree) {
    const std::string from = node_of(file.path);
    graph[from];
    for (const std::string& include : quoted_includes(file.text)) {
      const std::string to = node_of(path_of_include(include));
      if (to != from) graph[from].insert(to);
    }
  }
  return graph;
}

void add_reachable(const Graph& graph, const std::string& from, std::set<std::string>& reached) {
  const auto edges = graph.find(from);
  if (edges == graph.end()) return;
  for (const std::string& to : edges->second) {
    if (reached.insert(to).second) add_reachable(graph, to, reached);
  }
}

std::map<std::string, std::set<std::string>> reachable(const Graph& graph) {
  std::map<std::string, std::set<std::string>> all;
  for (const auto& [node, edges] : graph) add_reachable(graph, node, all[node]);
  return all;
}

}  // namespace

Faults include_loops(const Tree& tree) {
  const Graph graph = graph_of(tree, without_extension);
  const auto reached = reachable(graph);
  std::set<std::string> loops;
  for (const auto& [node, from] : reached) {
    if (from.count(node) == 0) continue;
    std::string loop;
    for (const auto& [other, back] : reached) {
      if (from.count(other) != 0 && back.count(node) != 0) loop += (loop.empty() ? "" : ", ") + other;
    }
    loops.insert(loop);
  }
  return {loops.begin(), loops.end()};
}

std::string layer_chart(const Tree& tree) {
  const Graph graph = graph_of(tree, layer_of);
  const auto reached = reachable(graph);
  const auto name = [](const std::string& layer) { return layer.substr(layer.find('/') + 1); };
  const auto id = [&](const std::string& layer) { return (layer.starts_with("runtime") ? "r_" : "g_") + name(layer); };
  std::string chart = "flowchart TD\n";
  for (const std::string half : {"generator", "runtime"}) {
    chart += "  subgraph " + half + "\n";
    for (const auto& [layer, edges] : graph) {
      if (layer.starts_with(half)) chart += "    " + id(layer) + "[" + name(layer) + "]\n";
    }
    chart += "  end\n";
  }
  for (const auto& [from, edges] : graph) {
    for (const std::string& to : edges) {
      const bool follows = std::any_of(edges.begin(), edges.end(), [&](const std::string& other) {
        const auto further = reached.find(other);
        return other != to && further != reached.end() && further->second.count(to) != 0;
      });
      if (!follows) chart += "  " + id(from) + " --> " + id(to) + "\n";
    }
  }
  return chart;
}

}  // namespace symplant::arch
