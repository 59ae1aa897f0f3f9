// What the plan and the 3D view show besides the plant: the layout, and the camera that the trainer chose.
#include "symplant/panel/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "symplant/json/document.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/picture/stations.hpp"
#include "symplant/tables/file_name.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/trace/whole_file.hpp"

namespace symplant::panel {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kFile = "layout.json";

std::vector<std::string> keys_of(std::string_view text, const char* member) {
  std::vector<std::string> keys;
  if (text.empty()) return keys;
  const Json object = Json::parse(text);
  const auto found = object.find(member);
  if (found == object.end()) return keys;
  for (const auto& [key, value] : found->items()) keys.push_back(key);
  return keys;
}

}  // namespace

/// The names that a layout may have.
struct Scene::Known {
  std::set<std::string, std::less<>> frames;
  std::set<std::string_view> devices;
  std::set<std::string_view> locations;

  Known(const trace::PlantNames& names, const View& view) {
    for (const Station& station : stations_of(names, view).stations) frames.insert(station.name());
    for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) devices.insert(names.unit(unit));
    const tables::MaterialTables& material = names.tables().material;
    for (std::uint32_t i = 0; i < material.tracks.size() + material.places.size(); ++i) {
      locations.insert(names.location(i));
    }
  }
};

Scene::Scene(const trace::PlantNames& names, const View& view, std::string folder)
    : names_(names),
      folder_(std::move(folder)),
      plan_(view.plan.empty() ? "{}" : view.plan),
      cameras_(keys_of(view.view3d, "cameras")),
      schema_(layout_schema()),
      known_(std::make_unique<const Known>(names, view)) {}

Scene::~Scene() = default;

std::string Scene::layout() const { return fmt::format("{{\"revision\":{},\"plan\":{}}}", revision_, plan_); }

/// What is wrong with the first wrong name.
std::string Scene::wrong_name(const Json& plan) const {
  auto frames = known_->frames;
  if (const auto devices = plan.find("devices"); devices != plan.end()) {
    for (const Json& device : *devices) {
      if (device.contains("group")) frames.insert(device["group"].get<std::string>());
    }
  }
  const auto first_wrong = [&](const char* key, const auto& known, std::string_view words) -> std::string {
    const auto object = plan.find(key);
    if (object == plan.end()) return {};
    for (const auto& [name, value] : object->items()) {
      if (known.contains(name)) continue;
      tables::NearestName nearest(name);
      for (const auto& each : known) nearest.offer(each);
      return fmt::format("{} `{}` not found{}", words, name,
                         nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name()));
    }
    return {};
  };
  if (const auto background = plan.find("background"); background != plan.end()) {
    const std::string& file = background->at("file").get_ref<const std::string&>();
    if (!tables::is_picture_name(file)) return fmt::format("`{}` is not the name of an .svg or .png file", file);
  }
  std::string wrong = first_wrong("devices", known_->devices, "device");
  if (wrong.empty()) wrong = first_wrong("locations", known_->locations, "track or place");
  if (wrong.empty()) wrong = first_wrong("frames", frames, "station or group");
  return wrong;
}

Scene::Draft Scene::read(std::string_view body) const {
  const json::Document document = json::parse(body);
  if (document.root == nullptr || !document.faults.empty()) {
    return {.refusal =
                error_answer(400, document.faults.empty() ? "the body is not JSON" : document.faults.front().message)};
  }
  if (const auto faults = schema_.check(*document.root); !faults.empty()) {
    return {.refusal = error_answer(422, fmt::format("`{}`: {}", faults.front().pointer, faults.front().message))};
  }
  const Json& plan = document.root->at("plan");
  if (std::string wrong = wrong_name(plan); !wrong.empty()) return {.refusal = error_answer(422, wrong)};
  Draft draft{.plan = plan.dump()};
  if (document.root->contains("revision")) draft.revision = document.root->at("revision").get<std::uint64_t>();
  return draft;
}

Answer Scene::write(const Draft& draft) const {
  if (folder_.empty()) return {200, "{\"file\":null}"};
  const std::string path = (std::filesystem::path(folder_) / kFile).generic_string();
  const Json file = {{"symplant", 1}, {"plan", Json::parse(draft.plan)}};
  const std::string failure = trace::write_whole_file(path, file.dump(2) + "\n");
  if (!failure.empty()) return error_answer(422, fmt::format("cannot write `{}`: {}", path, failure));
  std::string answer = "{\"file\":";
  put_text(answer, path);
  return {200, answer + "}"};
}

void Scene::take(Draft draft) {
  plan_ = std::move(draft.plan);
  ++revision_;
}

bool Scene::has_camera(std::string_view name) const {
  return name.empty() || std::find(cameras_.begin(), cameras_.end(), name) != cameras_.end();
}

std::string_view Scene::nearest_camera(std::string_view name) const {
  tables::NearestName nearest(name);
  std::string_view found;
  for (const std::string& camera : cameras_) nearest.offer(camera);
  for (const std::string& camera : cameras_) {
    if (camera == nearest.name()) found = camera;
  }
  return found;
}

void Scene::switch_camera(std::string name) {
  camera_ = std::move(name);
  ++camera_switches_;
}

void Scene::put_camera(std::string& json) const {
  if (camera_switches_ == 0) return void(json += "null");
  put(json, "{{\"n\":{}", camera_switches_);
  put_member(json, "name", camera_);
  json += '}';
}

}  // namespace symplant::panel
