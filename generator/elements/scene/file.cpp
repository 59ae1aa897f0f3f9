// Reads which nodes a model of the 3D view has.
#include "elements/scene/file.hpp"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
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

class ModelReader {
 public:
  explicit ModelReader(const Json& nodes) : nodes_(nodes), parents_(nodes.size()) {}

  ModelReading read() {
    ModelReading reading;
    reading.error = find_parents();
    for (std::size_t node = 0; node < nodes_.size() && reading.error.empty(); ++node) {
      if (auto path = path_of(node)) {
        if (!path->empty()) reading.paths.push_back(std::move(*path));
      } else {
        return {{}, "its nodes are nested more than 64 deep, or in a circle"};
      }
    }
    return reading;
  }

 private:
  /// Returns what is wrong with the tree of nodes; empty if nothing is.
  std::string find_parents() {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Json* const children = member(nodes_[node], "children");
      if (children == nullptr) continue;
      if (!children->is_array()) return "`children` of a node is no array";
      for (const Json& child : *children) {
        if (!child.is_number_unsigned() || child.get<std::size_t>() >= nodes_.size()) {
          return "a node has a child that the model does not have";
        }
        std::optional<std::size_t>& parent = parents_[child.get<std::size_t>()];
        if (parent) return "a node has two parents";
        parent = node;
      }
    }
    return {};
  }

  /// Empty without a name; nothing if it is nested too deep.
  std::optional<std::string> path_of(std::size_t node) const {
    std::string path = text_or_empty(nodes_[node], "name");
    if (path.empty()) return path;
    std::size_t levels = 0;
    for (std::optional<std::size_t> at = parents_[node]; at; at = parents_[*at]) {
      if (++levels > kMostModelLevels) return std::nullopt;
      if (const std::string name = text_or_empty(nodes_[*at], "name"); !name.empty()) path.insert(0, name + "/");
    }
    return path;
  }

  const Json& nodes_;
  std::vector<std::optional<std::size_t>> parents_;
};

bool is_end(std::string_view path, std::string_view end) {
  return path.ends_with(end) && (path.size() == end.size() || path[path.size() - end.size() - 1] == '/');
}

std::string_view nearest_node(std::string_view node, const std::vector<std::string>& paths) {
  tables::NearestName nearest(node);
  for (const std::string& path : paths) {
    nearest.offer(path);
    nearest.offer(std::string_view(path).substr(path.rfind('/') + 1));
  }
  return nearest.name();
}

/// What is wrong with the path of a node; empty if one node has it.
std::string node_fault(const std::string& node, const std::vector<std::string>& paths) {
  std::vector<std::string_view> whole;
  std::vector<std::string_view> ends;
  for (const std::string& path : paths) {
    if (path == node) whole.push_back(path);
    if (is_end(path, node)) ends.push_back(path);
  }
  if (whole.size() == 1 || (whole.empty() && ends.size() == 1)) return {};
  if (ends.empty()) return missing("node " + ticked(node) + " of the model", nearest_node(node, paths));
  return "several nodes of the model are " + ticked(node) + ", such as " + ticked(ends[0]) + " and " + ticked(ends[1]) +
         "; write the whole path, or give one of them another name";
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
  return ModelReader(*nodes).read();
}

void check_model(std::string_view bytes, const GivenScene& scene, std::vector<DescriptionFault>& faults) {
  const ModelReading model = read_model(bytes);
  if (!model.error.empty()) {
    return faults.push_back({"/view3d/model", ticked(scene.model) + ": " + model.error, 0, FaultKind::contradiction});
  }
  for (const SceneNode& node : scene.nodes) {
    if (std::string fault = node_fault(node.path, model.paths); !fault.empty()) {
      faults.push_back({node.pointer, std::move(fault), 0, FaultKind::unknown_name});
    }
  }
}

}  // namespace symplant::description
