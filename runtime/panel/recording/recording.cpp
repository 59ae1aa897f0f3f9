// A trace file as the panel shows it.
#include "symplant/panel/recording/recording.hpp"

#include <algorithm>
#include <utility>

#include "symplant/panel/picture/describe.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/recording/reconstruct.hpp"
#include "symplant/panel/web/query.hpp"
#include "symplant/panel/web/scene_file.hpp"

namespace symplant::panel {

Recording::Recording(trace::ReadTrace trace, const trace::PlantNames& names, const View& view, std::uint64_t model_hash,
                     SceneFiles files)
    : names_(names),
      records_(reconstruct(std::move(trace.records), names)),
      begin_(trace.begin),
      end_(trace.end),
      at_(trace.begin),
      at_end_(names),
      chart_(names, at_end_),
      scene_(names, view, ""),
      files_(std::move(files)) {
  for (const trace::Record& record : records_) {
    chart_.apply(record);
    at_end_.apply(record);
  }
  put_member(description_, "plant", names.tables().name);
  put(description_, R"(,"model_hash":"{:016x}","mode":"recording","acts":false,"with_plc":false,"speed":true,)",
      model_hash);
  put(description_, R"("files":false,"exercises":[],"begin":{},"end":{})", begin_, end_);
  std::string plant;
  put_plant(plant, names, view, {}, Role::trainer);
  description_ += "," + plant;
}

void Recording::go_to(tables::Time time) {
  if (!history_ || time < at_) {
    picture_.reset();
    history_.emplace(names_);
    picture_.emplace(names_, *history_);
    next_ = 0;
  }
  for (; next_ < records_.size() && records_[next_].time <= time; ++next_) {
    history_->apply(records_[next_]);
    picture_->apply(records_[next_]);
  }
  at_ = time;
}

std::string Recording::picture_at(tables::Time time) {
  go_to(std::clamp(time, begin_, end_));
  std::string json = "{";
  put(json, R"("rev":{},"t":{},"clock":{{"state":"frozen","speed":1,"real_speed":0}})", next_, at_);
  picture_->put_all(json, at_, Role::trainer);
  json +=
      R"(,"findings":[],"requirements":[],"acts":[],"snapshots":[],"exercise":null,"links":[],"cycle":null,"layout":0,"camera":null)";
  return json + "}";
}

std::optional<Reply> Recording::get(std::string_view path, const std::map<std::string, std::string>& query,
                                    const Sender& /*sender*/, const Answered& /*later*/) {
  if (std::optional<Reply> file = scene_file(path, files_)) return file;
  if (path == "layout") return Reply{Reply::Kind::now, {200, scene_.layout()}};
  if (path == "chart") {
    ChartWish wish;
    if (!read_chart(query, names_, wish)) return Reply{Reply::Kind::now, error_answer(400, kChartForm)};
    return Reply{Reply::Kind::now, {200, chart_.text(wish, end_)}};
  }
  if (path != "at") return std::nullopt;
  tables::Time time = 0;
  bool well = query.count("t") != 0;
  read_number(query, "t", time, well);
  if (!well) return Reply{Reply::Kind::now, error_answer(400, "`at` needs a time `t` in ns")};
  return Reply{Reply::Kind::now, {200, picture_at(time)}};
}

void Recording::post(std::string_view /*path*/, std::string_view /*body*/, const Sender& /*sender*/,
                     const Answered& later) {
  later(error_answer(403, "a recording only shows the plant"));
}

}  // namespace symplant::panel
