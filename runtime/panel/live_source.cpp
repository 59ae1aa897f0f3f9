// The panel's interface over a running plant.
#include "symplant/panel/live_source.hpp"

#include <tuple>
#include <utility>

#include "symplant/panel/web/query.hpp"
#include "symplant/panel/web/scene_file.hpp"

namespace symplant::panel {
namespace {

Reply csv_file(std::string text, std::string name) {
  Reply reply{Reply::Kind::now, {200, std::move(text)}, "text/csv; charset=utf-8"};
  reply.file_name = std::move(name);
  return reply;
}

}  // namespace

void LiveSource::put_description(std::string& json, Role role) {
  const std::lock_guard guard(mutex_);
  desk_.put_description(json, role);
  json += "," + describe_(role);
}

std::optional<Reply> LiveSource::get(std::string_view path, const std::map<std::string, std::string>& query,
                                     const Sender& sender, const Answered& later) {
  if (std::optional<Reply> file = scene_file(path, files_)) return file;  // without the mutex: it may take long
  const std::lock_guard guard(mutex_);
  if (path == "layout") return Reply{Reply::Kind::now, {200, scene_.layout()}};
  if (path == "chart") return chart(query);
  if (path == "utilization") return utilization(query, sender.role);
  if (path == "utilization.csv") {
    return csv_file(desk_.utilization_table(sender.role), std::string(path));
  }
  if (path == "why") {
    const auto name = query.find("name");
    if (name == query.end()) return Reply{Reply::Kind::now, error_answer(400, "`why` needs a `name`")};
    desk_.why(name->second, sender, later);
    return Reply{Reply::Kind::later, {}};
  }
  if (path == "training.csv" || path == "reactions.csv") {
    if (!sees_all(sender.role)) return Reply{Reply::Kind::now, error_answer(403, "the table is for the trainer")};
    const Training& training = desk_.training();
    return csv_file(path == "training.csv" ? training.trainees_csv() : training.reactions_csv(), std::string(path));
  }
  constexpr std::string_view kSession = "session/";
  if (!path.starts_with(kSession)) return std::nullopt;
  if (!sees_all(sender.role)) return Reply{Reply::Kind::now, error_answer(403, "the session is for the trainer")};
  return session_file(path.substr(kSession.size()));
}

Reply LiveSource::chart(const std::map<std::string, std::string>& query) {
  ChartWish wish;
  if (!read_chart(query, names_, wish)) return {Reply::Kind::now, error_answer(400, kChartForm)};
  return {Reply::Kind::now, {200, desk_.chart(wish)}};
}

Reply LiveSource::utilization(const std::map<std::string, std::string>& query, Role role) {
  if (!query.contains("device")) return {Reply::Kind::now, {200, desk_.utilization(role)}};
  std::uint32_t unit = 0;
  bool well = true;
  read_number(query, "device", unit, well);
  if (!well || unit >= names_.tables().units.size()) {
    return {Reply::Kind::now, error_answer(400, "`device` is the index of a device")};
  }
  return {Reply::Kind::now, {200, desk_.utilization_of(unit, role)}};
}

std::optional<Reply> LiveSource::session_file(std::string_view kind) {
  static const std::map<std::string_view, std::pair<std::string, std::string_view>> kKinds{
      {"scenario", {"session.scenario.json", "application/json"}},
      {"start", {"session.start.snapshot", "application/octet-stream"}},
      {"session", {"session.session.json", "application/json"}},
      {"junit", {"session.junit.xml", "application/xml"}}};
  const auto found = kKinds.find(kind);
  if (found == kKinds.end()) return std::nullopt;
  Reply reply{Reply::Kind::now, desk_.session_file(kind)};
  if (reply.answer.status == 200) std::tie(reply.file_name, reply.content_type) = found->second;
  return reply;
}

void LiveSource::post(std::string_view path, std::string_view body, const Sender& sender, const Answered& later) {
  if (path == "layout") return later(save_layout(body, sender));
  const std::lock_guard guard(mutex_);
  if (path == "check") return later(desk_.check(body, sender));
  desk_.request(body, sender, later);
}

/// The mutex is not held while the layout is read and written, so that the plant does not wait for it.
Answer LiveSource::save_layout(std::string_view body, const Sender& sender) {
  if (!sees_all(sender.role)) return error_answer(403, kOnlyTrainer);
  Scene::Draft draft = scene_.read(body);
  if (draft.refusal) return *draft.refusal;
  {
    const std::lock_guard guard(mutex_);
    if (desk_.has_ended()) return error_answer(503, "the run has ended");
    if (scene_.is_older(draft)) return error_answer(422, kMeanwhile);
  }
  Answer answer = scene_.write(draft);
  if (answer.status != 200) return answer;
  const std::lock_guard guard(mutex_);
  scene_.take(std::move(draft));
  desk_.layout_saved(sender);
  return answer;
}

/// Puts the members of the status before the brace at the end.
void LiveSource::put_status(std::string& json) const {
  if (!status_.empty()) json.insert(json.size() - 1, "," + status_);
}

std::string LiveSource::picture(Role role) {
  const std::lock_guard guard(mutex_);
  std::string json = desk_.picture(role);
  put_status(json);
  return json;
}

News LiveSource::changes(bool for_others) {
  const std::lock_guard guard(mutex_);
  const bool is_due = std::exchange(is_due_, false);
  desk_.look_at_changes();
  const auto changes_for = [&](Role role) {
    std::string json = desk_.changes(role);
    if (!is_due) return json;
    if (json.empty()) json = desk_.beat() + "}";
    put_status(json);
    return json;
  };
  News news{changes_for(Role::trainer), for_others ? changes_for(Role::trainee) : std::string()};
  desk_.forget_changes();
  return news;
}

bool LiveSource::begun_again() {
  const std::lock_guard guard(mutex_);
  return desk_.begun_again();
}

void LiveSource::refresh(const std::function<std::string()>& ask_status) {
  is_due_ = true;
  if (ask_status) status_ = ask_status();
}

}  // namespace symplant::panel
