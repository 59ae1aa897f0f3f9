// Reads which nodes a model of the 3D view has.
#include "elements/scene/file.hpp"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "description/faults.hpp"
#include "description/json_entry.hpp"
#include "symplant/json/document.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostModelBytes = std::size_t{32} << 20;
constexpr std::size_t kMostModelNodes = 20'000;
constexpr std::size_t kMostModelLevels = 64;
constexpr std::size_t kLongestModelName = 1'000;
constexpr std::size_t kHeader = 12;  ///< bytes: magic, version, length
constexpr std::size_t kChunk = 8;    ///< bytes of a chunk's header: length, type

/// A number of four bytes, the lowest first.
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

/// The JSON of a .glb file; empty if it has none.
std::string_view json_chunk(std::string_view bytes) {
  if (bytes.size() < kHeader + kChunk || !bytes.starts_with("glTF") || word_at(bytes, 4) != 2) return {};
  const std::size_t length = word_at(bytes, kHeader);
  if (bytes.substr(kHeader + 4, 4) != "JSON" || length > bytes.size() - kHeader - kChunk) return {};
  return bytes.substr(kHeader + kChunk, length);
}

/// The tree of nodes, in the order of the file.
class ModelReader {
 public:
  ModelReader(const Json& root, const Json& nodes) : root_(root), nodes_(nodes), tree_(nodes.size()) {}

  ModelReading read() {
    ModelReading reading;
    for (std::size_t node = 0; node < nodes_.size() && reading.error.empty(); ++node) {
      reading.error = read_node(node);
    }
    if (reading.error.empty()) reading.error = show();
    if (!reading.error.empty()) return reading;
    for (const Node& node : tree_) {
      if (node.shown) reading.nodes.push_back(node.made);
    }
    return reading;
  }

 private:
  struct Node {
    std::vector<std::size_t> children;
    bool is_child = false;
    bool shown = false;
    std::uint32_t index = 0;  ///< in ModelReading::nodes
    ModelNode made;
  };

  /// Returns what is wrong; empty if nothing is.
  std::string read_node(std::size_t node) {
    tree_[node].made.name = text_or_empty(nodes_[node], "name");
    if (tree_[node].made.name.size() > kLongestModelName) return "a node has a name of more than 1,000 bytes";
    const Json* const children = member(nodes_[node], "children");
    if (children == nullptr) return {};
    if (!children->is_array()) return "`children` of a node is no array";
    for (const Json& child : *children) {
      if (!child.is_number_unsigned() || child.get<std::size_t>() >= nodes_.size()) {
        return "a node has a child that the model does not have";
      }
      if (std::exchange(tree_[child.get<std::size_t>()].is_child, true)) return "a node has two parents";
      tree_[node].children.push_back(child.get<std::size_t>());
    }
    return {};
  }

  /// The roots of the scene that is shown; all roots in a model without scenes.
  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> roots;
    const Json* const scenes = member(root_, "scenes");
    const Json* const chosen = member(root_, "scene");
    const std::size_t index = chosen != nullptr && chosen->is_number_unsigned() ? chosen->get<std::size_t>() : 0;
    if (scenes != nullptr && scenes->is_array() && index < scenes->size()) {
      const Json* const nodes = member((*scenes)[index], "nodes");
      if (nodes == nullptr || !nodes->is_array()) return roots;
      for (const Json& node : *nodes) {
        if (node.is_number_unsigned() && node.get<std::size_t>() < tree_.size())
          roots.push_back(node.get<std::size_t>());
      }
      return roots;
    }
    for (std::size_t node = 0; node < tree_.size(); ++node) {
      if (!tree_[node].is_child) roots.push_back(node);
    }
    return roots;
  }

  /// Marks what is below the roots, level by level, and counts it. Each node has one parent, so a circle has no root.
  std::string show() {
    struct Step {
      std::size_t node;
      std::size_t named;  ///< the nearest ancestor with a name; kNoNode: none
    };
    constexpr std::size_t kNoNode = SIZE_MAX;
    std::vector<Step> level;
    for (const std::size_t root : roots()) level.push_back({root, kNoNode});
    std::vector<std::size_t> named(tree_.size(), kNoNode);
    for (std::size_t levels = 0; !level.empty(); ++levels) {
      if (levels >= kMostModelLevels) return "its nodes are nested more than 64 deep";
      std::vector<Step> next;
      for (const Step& step : level) {
        Node& node = tree_[step.node];
        if (std::exchange(node.shown, true)) return "a node is in its scene twice, or nodes are nested in a circle";
        named[step.node] = step.named;
        const std::size_t own = node.made.name.empty() ? step.named : step.node;
        for (const std::size_t child : node.children) next.push_back({child, own});
      }
      level = std::move(next);
    }
    std::uint32_t count = 0;
    for (Node& node : tree_) {
      if (node.shown) node.index = count++;
    }
    for (std::size_t node = 0; node < tree_.size(); ++node) {
      if (named[node] != kNoNode) tree_[node].made.parent = tree_[named[node]].index;
    }
    return {};
  }

  const Json& root_;
  const Json& nodes_;
  std::vector<Node> tree_;
};

/// How much of a path a node has: nothing, the end of the path to it, or all of it.
enum class Match : std::uint8_t { none, end, whole };

Match match(const std::vector<ModelNode>& nodes, std::uint32_t node, std::string_view path) {
  for (std::uint32_t at = node; at != ModelNode::kNoParent; at = nodes[at].parent) {
    const std::string& name = nodes[at].name;
    if (name.empty() || !path.ends_with(name)) return Match::none;
    path.remove_suffix(name.size());
    if (path.empty()) return nodes[at].parent == ModelNode::kNoParent ? Match::whole : Match::end;
    if (path.back() != '/') return Match::none;
    path.remove_suffix(1);
  }
  return Match::none;
}

std::string_view nearest_node(std::string_view path, const std::vector<ModelNode>& nodes) {
  tables::NearestName nearest(path.substr(path.rfind('/') + 1));
  for (const ModelNode& node : nodes) nearest.offer(node.name);
  return nearest.name();
}

/// What is wrong with the path of a node; empty if one node has it.
std::string node_fault(const std::string& path, const std::vector<ModelNode>& nodes) {
  std::vector<std::uint32_t> found;
  std::size_t whole = 0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    const Match how = match(nodes, node, path);
    if (how == Match::none) continue;
    if (how == Match::whole) ++whole;
    if (found.size() < 2) found.push_back(node);
  }
  if (whole == 1 || (whole == 0 && found.size() == 1)) return {};
  if (found.empty()) return missing("node " + ticked(path) + " of the model", nearest_node(path, nodes));
  return "several nodes of the model are " + ticked(path) + ", such as " + ticked(path_of(nodes, found[0])) + " and " +
         ticked(path_of(nodes, found[1])) + "; write the whole path, or give one of them another name";
}

}  // namespace

ModelReading read_model(std::string_view bytes) {
  if (bytes.size() > kMostModelBytes) return {{}, "it is larger than 32 MiB"};
  const std::string_view text = json_chunk(bytes);
  if (text.empty()) return {{}, "it is no binary glTF 2.0; export the model as .glb"};
  const json::Document document = json::parse(text);
  if (document.root == nullptr) return {{}, "its JSON is not valid: " + document.faults.front().message};
  const Json* const nodes = member(*document.root, "nodes");
  if (nodes == nullptr || !nodes->is_array()) return {{}, "it has no nodes"};
  if (nodes->size() > kMostModelNodes) return {{}, "it has more than 20,000 nodes"};
  return ModelReader(*document.root, *nodes).read();
}

std::string path_of(const std::vector<ModelNode>& nodes, std::uint32_t node) {
  std::string path = nodes[node].name;
  for (std::uint32_t at = nodes[node].parent; at != ModelNode::kNoParent; at = nodes[at].parent) {
    path.insert(0, nodes[at].name + "/");
  }
  return path;
}

void check_model(std::string_view bytes, const GivenScene& scene, std::vector<DescriptionFault>& faults) {
  const ModelReading model = read_model(bytes);
  if (!model.error.empty()) {
    return faults.push_back({"/view3d/model", ticked(scene.model) + ": " + model.error, 0, FaultKind::contradiction});
  }
  for (const SceneNode& node : scene.nodes) {
    if (std::string fault = node_fault(node.path, model.nodes); !fault.empty()) {
      faults.push_back({node.pointer, std::move(fault), 0, FaultKind::unknown_name});
    }
  }
}

}  // namespace symplant::description
