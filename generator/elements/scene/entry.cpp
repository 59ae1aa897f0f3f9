// Reads the plan and the 3D view of the panel.
#include "elements/scene/entry.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "symplant/json/location.hpp"
#include "symplant/tables/file_name.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;
using Kind = SceneName::Kind;

/// Keys of an entry of `nodes` that are not states.
constexpr std::array<std::string_view, 6> kNodeKeys{"node", "move", "turn", "color", "from", "to"};

class SceneReader {
 public:
  explicit SceneReader(ShapeFaults& faults) : faults_(faults) {}

  GivenScene read(const Json& root) {
    if (const Json* const plan = member(root, "plan"); plan != nullptr && plan->is_object()) read_plan(*plan);
    if (const Json* const view = member(root, "view3d"); view != nullptr && view->is_object()) read_view3d(*view);
    return std::move(scene_);
  }

 private:
  void read_plan(const Json& plan) {
    scene_.plan = plan.dump();
    if (const Json* const background = member(plan, "background"); background != nullptr) {
      const std::string file = text_or_empty(*background, "file");
      if (!file.empty() && !tables::is_picture_name(file)) {
        faults_.add(Pointer("/plan/background/file"), ticked(file) + " is not the name of an .svg or .png file: " +
                                                          tables::kFileNameForm + "; its folder is not part of it");
      }
    }
    names(plan, "/plan", "devices", Kind::device);
    names(plan, "/plan", "locations", Kind::location);
    names(plan, "/plan", "frames", Kind::frame);
    const Json* const devices = member(plan, "devices");
    if (devices == nullptr || !devices->is_object()) return;
    for (const auto& [device, entry] : devices->items()) {
      if (std::string group = text_or_empty(entry, "group"); !group.empty()) scene_.groups.push_back(std::move(group));
    }
  }

  void read_view3d(const Json& view) {
    scene_.view3d = view.dump();
    scene_.model = text_or_empty(view, "model");
    if (!scene_.model.empty() && !tables::is_model_name(scene_.model)) {
      faults_.add(Pointer("/view3d/model"), ticked(scene_.model) + " is not the name of a .glb file: " +
                                                tables::kFileNameForm + "; its folder is not part of it");
    }
    const Json* const nodes = member(view, "nodes");
    if (nodes == nullptr || !nodes->is_object()) return;
    for (const auto& [name, entry] : nodes->items()) {
      if (entry.is_object()) read_node(name, entry, json::child("/view3d/nodes", name));
    }
  }

  void read_node(const std::string& name, const Json& entry, const std::string& here) {
    if (std::string path = text_or_empty(entry, "node"); !path.empty()) {
      scene_.nodes.push_back({std::move(path), json::child(here, "node")});
    }
    if (entry.contains("from") || entry.contains("to")) {
      scene_.names.push_back({Kind::location, name, {}, here});
    }
    for (const auto& [key, value] : entry.items()) {
      const std::string at = json::child(here, key);
      const bool is_state = std::find(kNodeKeys.begin(), kNodeKeys.end(), key) == kNodeKeys.end();
      if (is_state) scene_.names.push_back({Kind::posed, name, key, at});
      if (is_state || !value.is_object()) continue;
      if (std::string by = text_or_empty(value, "by"); !by.empty()) {
        scene_.names.push_back({Kind::number, std::move(by), {}, json::child(at, "by")});
      }
    }
  }

  void names(const Json& object, const std::string& here, std::string_view key, Kind kind) {
    const Json* const given = member(object, key);
    if (given == nullptr || !given->is_object()) return;
    const std::string at = json::child(here, key);
    for (const auto& [name, value] : given->items()) {
      check_text(name, Pointer(at) / std::string_view(name), faults_);
      scene_.names.push_back({kind, name, {}, json::child(at, name)});
    }
  }

  ShapeFaults& faults_;
  GivenScene scene_;
};

}  // namespace

GivenScene scene_of(const Json& root, ShapeFaults& faults) { return SceneReader(faults).read(root); }

}  // namespace symplant::description
