// From a request to its answer.
#include "symplant/panel/web/routes.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/training/sender_name.hpp"
#include "symplant/panel/web/page_files.hpp"
#include "symplant/panel/web/percent.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::panel {
namespace {

constexpr int kMostPosts = 100;  ///< in a second, for each role
constexpr std::string_view kApi = "/api/v1/";

Reply error_reply(int status, std::string_view what) { return {Reply::Kind::now, error_answer(status, what)}; }

Reply nothing_there() { return error_reply(404, "there is nothing at this address"); }

Reply content_reply(std::shared_ptr<Content> content) {
  return {.kind = Reply::Kind::now, .content = std::move(content)};
}

std::string_view content_type_of(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".svg")) return "image/svg+xml";
  return "text/javascript; charset=utf-8";
}

}  // namespace

bool split_target(std::string_view target, std::string& path, std::map<std::string, std::string>& query) {
  const std::size_t mark = target.find('?');
  if (!decode_percent(target.substr(0, mark), false, path) || !path.starts_with('/')) return false;
  std::string_view rest = mark == target.npos ? std::string_view() : target.substr(mark + 1);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view pair = rest.substr(0, end);
    const std::size_t equals = std::min(pair.find('='), pair.size());
    std::string key;
    std::string value;
    if (!decode_percent(pair.substr(0, equals), true, key)) return false;
    if (!decode_percent(equals < pair.size() ? pair.substr(equals + 1) : std::string_view(), true, value)) return false;
    query[key] = value;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return true;
}

Routes::Routes(Source& source, const Access& access, std::string run)
    : source_(source), access_(access), run_(std::move(run)) {}

Reply Routes::answer(const Request& request, const Answered& later) {
  if (!access_.is_own(request.claim)) {
    return error_reply(403, "this address is not that of the panel: use the link that the program printed");
  }
  if (request.method == "GET") return get(request, later);
  if (request.method == "POST") return post(request, later);
  return error_reply(405, "only GET and POST are possible");
}

Reply Routes::description(Role role) {
  std::shared_ptr<Content>& kept = descriptions_[static_cast<std::size_t>(role)];
  if (kept == nullptr) {
    std::string json = "{\"symplant-panel\":1";
    put_member(json, "version", tables::version());
    put_member(json, "run", run_);
    put_member(json, "role", role_name(role));
    source_.put_description(json, role);
    kept = std::make_shared<Content>("application/json", json + "}");
  }
  return content_reply(kept);
}

/// 404 if the page has no such file.
Reply Routes::page_file(std::string_view path) {
  const std::string_view name = path == "/" ? "index.html" : path.substr(1);
  const auto files = page_files();
  const auto file = std::find_if(files.begin(), files.end(), [&](const PageFile& each) { return each.name == name; });
  if (file == files.end()) return nothing_there();
  std::shared_ptr<Content>& kept = page_[file->name];
  if (kept == nullptr) {
    kept = std::make_shared<Content>(content_type_of(file->name), std::string(file->text), Packing::small);
  }
  return content_reply(kept);
}

Reply Routes::get(const Request& request, const Answered& later) {
  std::string path;
  std::map<std::string, std::string> query;
  if (!split_target(request.target, path, query)) {
    return error_reply(400, "the address does not begin with `/`, or has an invalid escape");
  }
  if (!path.starts_with(kApi)) return page_file(path);
  const std::optional<Role> role = access_.role(request.claim);
  if (!role) {
    return error_reply(401,
                       "this panel needs the token, even to look at the plant: use the link that the program printed");
  }
  const std::string_view what = std::string_view(path).substr(kApi.size());
  if (what == "plant") return description(*role);
  if (what == "stream") {
    const bool has_token = access_.role_by_token(request.claim).has_value();
    return {.kind = Reply::Kind::stream, .role = *role, .has_token = has_token};
  }
  if (what == "picture") return {Reply::Kind::now, {200, source_.picture(*role)}};
  if (what == "openapi.json") return {Reply::Kind::now, {200, std::string(openapi())}};
  std::optional<Reply> reply = source_.get(what, query, {*role}, later);
  return reply ? std::move(*reply) : nothing_there();
}

Reply Routes::post(const Request& request, const Answered& later) {
  const std::string_view path = request.target;
  if (path != "/api/v1/acts" && path != "/api/v1/check" && path != kLayoutTarget) return nothing_there();
  if (!request.content_type.starts_with("application/json")) {
    return error_reply(400, "the Content-Type of an act is application/json");
  }
  const std::optional<Role> role = access_.role_by_token(request.claim);
  if (!role) return error_reply(401, "acts need the token: use the link that the program printed");
  if (!source_.acts()) return error_reply(403, "this panel only shows the plant");
  if (*role == Role::viewer) return error_reply(403, "the link of this page only shows the plant");
  if (request.run != run_) {
    return error_reply(409, "the program was started again since this page was loaded: load it again");
  }
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  const std::int64_t second = std::chrono::duration_cast<std::chrono::seconds>(now).count();
  if (second != second_) acts_ = {};
  second_ = second;
  if (++acts_[static_cast<std::size_t>(*role)] > kMostPosts)
    return error_reply(429, "more than 100 acts in a second; try again");
  Sender sender{*role, {}};
  if (!read_sender_name(request.name, sender.name)) return error_reply(400, kNameForm);
  source_.post(path.substr(kApi.size()), request.body, sender, later);
  return {Reply::Kind::later, {}};
}

}  // namespace symplant::panel
