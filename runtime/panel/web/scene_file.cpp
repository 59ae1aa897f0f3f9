// The pictures and models of the panel over HTTP.
#include "symplant/panel/web/scene_file.hpp"

#include <cstddef>
#include <utility>
#include <variant>

namespace symplant::panel {

namespace {

constexpr std::size_t kMostPacked = std::size_t{1} << 20;  ///< bytes: to compress more would delay other clients

}  // namespace

std::optional<Reply> scene_file(std::string_view path, SceneFiles& files) {
  if (path == "files") return Reply{Reply::Kind::now, {200, files.list()}};
  constexpr std::string_view kFiles = "files/";
  if (!path.starts_with(kFiles)) return std::nullopt;
  auto read = files.read(path.substr(kFiles.size()));
  if (auto* const answer = std::get_if<Answer>(&read)) return Reply{Reply::Kind::now, std::move(*answer)};
  Reply reply;
  reply.content = std::get<std::shared_ptr<Content>>(std::move(read));
  reply.packable = reply.content->type() == "image/svg+xml" && reply.content->plain()->size() <= kMostPacked;
  return reply;
}

}  // namespace symplant::panel
