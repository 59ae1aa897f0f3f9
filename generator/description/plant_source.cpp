// The files of a plant description.
#include "description/plant_source.hpp"

#include <filesystem>
#include <utility>

namespace symplant::description {

Origin Origin::member(const std::string& key) const {
  const auto found = members.find(key);
  return found != members.end() ? found->second : Origin{file, pointer + "/" + key};
}

PlantSource::PlantSource(std::shared_ptr<const text::SourceFile> file) { files_.push_back(std::move(file)); }

PlantSource::PlantSource(std::vector<std::shared_ptr<const text::SourceFile>> files, Origin root)
    : files_(std::move(files)), root_(std::move(root)) {}

std::vector<std::string> PlantSource::paths() const {
  std::vector<std::string> paths;
  for (const auto& file : files_) paths.push_back(file->path());
  return paths;
}

Origin PlantSource::origin(std::string_view pointer) const {
  const Origin* origin = &root_;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    const auto found = origin->members.find(pointer.substr(1, end - 1));
    if (found == origin->members.end()) break;
    origin = &found->second;
    pointer.remove_prefix(end);
  }
  return {origin->file, origin->pointer + std::string(pointer)};
}

std::string PlantSource::folder(std::string_view pointer) const {
  return std::filesystem::path(files_[origin(pointer).file]->path()).parent_path().generic_string();
}

std::vector<PlantSource::Place> PlantSource::places(std::span<const json::Fault> values) const {
  std::vector<std::vector<json::Fault>> wanted(files_.size());
  std::vector<std::vector<std::size_t>> indexes(files_.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    Origin at = origin(values[i].pointer);
    wanted[at.file].push_back({std::move(at.pointer), {}, values[i].column, values[i].at_key});
    indexes[at.file].push_back(i);
  }
  std::vector<Place> places(values.size());
  for (std::size_t f = 0; f < files_.size(); ++f) {
    if (wanted[f].empty()) continue;
    const std::vector<json::Placed> found = json::locate(files_[f]->text(), wanted[f]);
    for (std::size_t i = 0; i < found.size(); ++i) places[indexes[f][i]] = {f, found[i].span};
  }
  return places;
}

}  // namespace symplant::description
