// The pictures and models of the panel over HTTP.
#include "symplant/panel/web/scene_file.hpp"

#include <utility>
#include <variant>

namespace symplant::panel {

std::optional<Reply> scene_file(std::string_view path, const SceneFiles& files) {
  if (path == "files") return Reply{Reply::Kind::now, {200, files.list()}};
  constexpr std::string_view kFiles = "files/";
  if (!path.starts_with(kFiles)) return std::nullopt;
  auto read = files.read(path.substr(kFiles.size()));
  if (auto* const answer = std::get_if<Answer>(&read)) return Reply{Reply::Kind::now, std::move(*answer)};
  auto& file = std::get<SceneFiles::File>(read);
  Reply reply{Reply::Kind::now, {200, std::move(file.bytes)}, file.type};
  reply.packable = file.type == "image/svg+xml";
  return reply;
}

}  // namespace symplant::panel
