// What the plan and the 3D view show besides the plant: the layout, and the camera that the trainer chose.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/json/schema.hpp"
#include "symplant/panel/answer.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// The form of POST /api/v1/layout, as JSON Schema.
std::string_view layout_schema();

/// The longest layout that can be saved, in bytes.
inline constexpr std::size_t kLongestLayout = std::size_t{1} << 20;

/// The answer to a layout that is older than the current one.
inline constexpr const char* kMeanwhile =
    "another layout was saved meanwhile; look at it first, or save again to replace it";

/// Not thread-safe, except what Draft says.
class Scene {
 public:
  /// `folder`: in which save() writes; empty: nowhere. `names` must outlive it. O(devices + the view's texts).
  Scene(const trace::PlantNames& names, const View& view, std::string folder);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The answer to GET /api/v1/layout. O(layout).
  std::string layout() const;
  /// A layout that a client saves: read(), then write(), then take(). The first two use nothing that changes, and may
  /// run while another thread calls the other functions.
  struct Draft {
    std::string plan = {};                       ///< as JSON
    std::optional<std::uint64_t> revision = {};  ///< on which it is based; nothing: the client does not say
    std::optional<Answer> refusal = {};          ///< the layout is not valid
  };
  /// Reads the body of POST /api/v1/layout. O(body * log(names)).
  Draft read(std::string_view body) const;
  /// Writes it to `layout.json` in the folder, if there is one. Returns the answer to the client.
  Answer write(const Draft& draft) const;
  /// Everyone gets it.
  void take(Draft draft);
  /// Whether another layout was saved since the one that it is based on.
  bool is_older(const Draft& draft) const { return draft.revision && *draft.revision != revision_; }
  std::uint64_t revision() const { return revision_; }

  /// Whether plant.json has this camera; an empty name is the overview of everything.
  bool has_camera(std::string_view name) const;
  /// The known camera with the most similar name; empty: none is similar.
  std::string_view nearest_camera(std::string_view name) const;
  void switch_camera(std::string name);
  std::uint64_t camera_switches() const { return camera_switches_; }

  /// The value of the key `camera` of the stream.
  void put_camera(std::string& json) const;

 private:
  struct Known;
  std::string wrong_name(const nlohmann::json& plan) const;  // empty: all names exist

  const trace::PlantNames& names_;
  std::string folder_;
  std::string plan_;  ///< as JSON
  std::uint64_t revision_ = 0;
  std::vector<std::string> cameras_;  ///< in the order of their names
  std::string camera_;
  std::uint64_t camera_switches_ = 0;
  json::Schema schema_;
  std::unique_ptr<const Known> known_;
};

}  // namespace symplant::panel
