// The pictures and models of the panel, in files.
#include "symplant/panel/scene/files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/file_name.hpp"

namespace symplant::panel {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostListed = 1000;

struct FileType {
  std::string_view ending;
  std::string_view type;
};
constexpr std::array kTypes{FileType{".svg", "image/svg+xml"}, FileType{".png", "image/png"},
                            FileType{".glb", "model/gltf-binary"}};

/// The Content-Type of a file by its name; empty for other files.
std::string_view type_of(std::string_view name) {
  if (!tables::is_file_name(name)) return {};
  for (const FileType& each : kTypes) {
    if (name.ends_with(each.ending)) return each.type;
  }
  return {};
}

}  // namespace

SceneFiles::SceneFiles(std::vector<std::string> folders) : folders_(std::move(folders)) {
  std::erase_if(folders_, [](const std::string& folder) { return folder.empty(); });
}

std::string SceneFiles::list() const {
  std::set<std::string> names;
  for (const std::string& folder : folders_) {
    std::error_code error;
    for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
      std::string name = file->path().filename().generic_string();
      std::error_code unknown;
      if (!type_of(name).empty() && file->is_regular_file(unknown)) names.insert(std::move(name));
      if (names.size() > kMostListed) names.erase(std::prev(names.end()));
    }
  }
  std::string json = "{\"files\":[";
  for (const std::string& name : names) {
    put_comma(json);
    put_text(json, name);
  }
  return json + "]}";
}

std::variant<std::shared_ptr<Content>, Answer> SceneFiles::read(std::string_view name) {
  const std::string_view type = type_of(name);
  if (type.empty()) return error_answer(404, "only .svg, .png and .glb files are here, by their plain names");
  for (const std::string& folder : folders_) {
    const fs::path path = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_regular_file(path, error)) return read_from(std::string(name), path, type);
  }
  return error_answer(404, fmt::format("`{}` is neither in the folder of --panel-files nor next to plant.json", name));
}

std::variant<std::shared_ptr<Content>, Answer> SceneFiles::read_from(const std::string& name, const fs::path& path,
                                                                     std::string_view type) {
  std::error_code error;
  std::error_code no_time;
  Kept next{path.generic_string(), fs::last_write_time(path, no_time), fs::file_size(path, error), nullptr};
  if (error || no_time) return error_answer(422, fmt::format("`{}` cannot be read", name));
  if (next.size > kMostFileBytes) return error_answer(422, fmt::format("`{}` is larger than 32 MiB", name));
  Kept& kept = kept_[name];
  if (kept.content != nullptr && kept.path == next.path && kept.changed == next.changed && kept.size == next.size) {
    return kept.content;
  }
  std::string bytes(static_cast<std::size_t>(next.size), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    kept_.erase(name);
    return error_answer(422, fmt::format("`{}` cannot be read", name));
  }
  next.content = std::make_shared<Content>(type, std::move(bytes));
  std::shared_ptr<Content> content = next.content;
  kept = std::move(next);
  const auto sum = [](std::uintmax_t total, const auto& each) { return total + each.second.size; };
  if (std::accumulate(kept_.begin(), kept_.end(), std::uintmax_t{0}, sum) > kMostKept) kept_.clear();
  return content;
}

}  // namespace symplant::panel
