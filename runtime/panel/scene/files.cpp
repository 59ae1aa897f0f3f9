// The pictures and models of the panel, in files.
#include "symplant/panel/scene/files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "symplant/panel/operate/act_reader.hpp"
#include "symplant/panel/picture/json_text.hpp"

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
  if (!is_file_name(name)) return {};
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
      if (names.size() < kMostListed && !type_of(name).empty() && file->is_regular_file(unknown)) {
        names.insert(std::move(name));
      }
    }
  }
  std::string json = "{\"files\":[";
  for (const std::string& name : names) {
    put_comma(json);
    put_text(json, name);
  }
  return json + "]}";
}

std::variant<SceneFiles::File, Answer> SceneFiles::read(std::string_view name) const {
  const std::string_view type = type_of(name);
  if (type.empty()) return error_answer(404, "only .svg, .png and .glb files are here, by their plain names");
  for (const std::string& folder : folders_) {
    const fs::path path = fs::path(folder) / name;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) continue;
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > kMostFileBytes) return error_answer(422, fmt::format("`{}` is larger than 32 MiB", name));
    File file{std::string(error ? 0 : static_cast<std::size_t>(size), '\0'), type};
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()))) {
      return error_answer(422, fmt::format("`{}` cannot be read", name));
    }
    return file;
  }
  return error_answer(404, fmt::format("`{}` is neither in the folder of --panel-files nor next to plant.json", name));
}

}  // namespace symplant::panel
