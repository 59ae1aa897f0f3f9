// A trace file as the panel shows it, without a plant that runs.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symplant/panel/picture/chart.hpp"
#include "symplant/panel/picture/picture.hpp"
#include "symplant/panel/scene/files.hpp"
#include "symplant/panel/scene/scene.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/panel/web/routes.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/read_trace.hpp"

namespace symplant::panel {

/// A trace has no states of devices and no positions of parts between the locations. Both are reconstructed: a device
/// is in the state whose events are on, and moves while none is; a part moves evenly from where it came past the
/// sensors that saw it to the end of its track. All roles see everything. Used by one thread at a time.
class Recording final : public Source {
 public:
  /// `names` must outlive it. O(records * log(records)).
  Recording(trace::ReadTrace trace, const trace::PlantNames& names, const View& view, std::uint64_t model_hash,
            SceneFiles files = SceneFiles({}));

  void put_description(std::string& json, Role /*role*/) override { json += "," + description_; }
  bool acts() const override { return false; }
  std::optional<Reply> get(std::string_view path, const std::map<std::string, std::string>& query, const Sender& sender,
                           const Answered& later) override;
  void post(std::string_view path, std::string_view body, const Sender& sender, const Answered& later) override;
  std::string picture(Role /*role*/) override { return picture_at(at_); }
  News changes(bool /*for_others*/) override { return {}; }

  /// The data of the event `picture` at a time. O(records between the last call and this one), from the beginning if
  /// the time is before that of the last call.
  std::string picture_at(tables::Time time);

 private:
  void go_to(tables::Time time);

  const trace::PlantNames& names_;
  std::vector<trace::Record> records_;
  tables::Time begin_;
  tables::Time end_;
  tables::Time at_;
  std::size_t next_ = 0;  ///< the first record that is not applied
  std::optional<trace::History> history_;
  std::optional<Picture> picture_;
  trace::History at_end_;  ///< for the chart
  Chart chart_;
  std::string description_;
  Scene scene_;
  SceneFiles files_;
};

}  // namespace symplant::panel
