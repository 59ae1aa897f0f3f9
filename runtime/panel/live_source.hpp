// The panel's interface over a running plant.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/scene/files.hpp"
#include "symplant/panel/scene/scene.hpp"
#include "symplant/panel/web/routes.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// Each call holds the mutex of the desk.
class LiveSource final : public Source {
 public:
  /// `describe` makes the members that follow from the tables, for a role. The others must outlive it.
  LiveSource(Desk& desk, std::mutex& mutex, const trace::PlantNames& names, Scene& scene, SceneFiles& files,
             std::function<std::string(Role)> describe)
      : desk_(desk), mutex_(mutex), names_(names), scene_(scene), files_(files), describe_(std::move(describe)) {}

  void put_description(std::string& json, Role role) override;
  bool acts() const override { return desk_.acts(); }
  std::optional<Reply> get(std::string_view path, const std::map<std::string, std::string>& query, const Sender& sender,
                           const Answered& later) override;
  void post(std::string_view path, std::string_view body, const Sender& sender, const Answered& later) override;
  std::string picture(Role role) override;
  News changes(bool for_others) override;
  bool begun_again() override;

  /// To be called about once a second, by a caller that holds the mutex: the next changes() are not empty. `ask_status`
  /// makes the members `links` and `cycle`; null: they stay as they are.
  void refresh(const std::function<std::string()>& ask_status);

 private:
  void put_status(std::string& json) const;
  Answer save_layout(std::string_view body, const Sender& sender);
  Reply chart(const std::map<std::string, std::string>& query);
  Reply utilization(const std::map<std::string, std::string>& query, Role role);
  std::optional<Reply> session_file(std::string_view kind);

  Desk& desk_;
  std::mutex& mutex_;
  const trace::PlantNames& names_;
  Scene& scene_;
  SceneFiles& files_;  ///< for the panel's thread only
  std::function<std::string(Role)> describe_;
  std::string status_;
  bool is_due_ = false;  ///< changes() must not be empty
};

}  // namespace symplant::panel
