// The panel's interface over a running plant.
#include "symplant/panel/live_source.hpp"

#include <tuple>
#include <utility>

#include "symplant/panel/web/query.hpp"

namespace symplant::panel {

void LiveSource::put_description(std::string& json) {
  const std::lock_guard guard(mutex_);
  desk_.put_description(json);
  json += "," + description_;
}

std::optional<Reply> LiveSource::get(std::string_view path, const std::map<std::string, std::string>& query,
                                     const Answered& later) {
  const std::lock_guard guard(mutex_);
  if (path == "chart") return chart(query);
  if (path == "why") {
    const auto name = query.find("name");
    if (name == query.end()) return Reply{Reply::Kind::now, error_answer(400, "`why` needs a `name`")};
    desk_.why(name->second, later);
    return Reply{Reply::Kind::later, {}};
  }
  constexpr std::string_view kSession = "session/";
  return path.starts_with(kSession) ? session_file(path.substr(kSession.size())) : std::nullopt;
}

Reply LiveSource::chart(const std::map<std::string, std::string>& query) {
  ChartWish wish;
  if (!read_chart(query, names_, wish)) return {Reply::Kind::now, error_answer(400, kChartForm)};
  return {Reply::Kind::now, {200, desk_.chart(wish)}};
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

void LiveSource::post(std::string_view path, std::string_view body, const Answered& later) {
  const std::lock_guard guard(mutex_);
  path == "check" ? later(desk_.check(body)) : desk_.request(body, later);
}

std::string LiveSource::picture() {
  const std::lock_guard guard(mutex_);
  std::string json = desk_.picture();
  json.insert(json.size() - 1, status_.empty() ? "" : "," + status_);
  return json;
}

std::string LiveSource::changes() {
  const std::lock_guard guard(mutex_);
  std::string json = desk_.changes();
  if (!std::exchange(is_due_, false)) return json;
  if (json.empty()) json = desk_.beat() + "}";
  json.insert(json.size() - 1, status_.empty() ? "" : "," + status_);
  return json;
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
