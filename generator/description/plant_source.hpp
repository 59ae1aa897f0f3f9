// The files of a plant description: plant.json, and those that it includes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diag/diagnostic.hpp"
#include "symplant/json/location.hpp"
#include "text/source_file.hpp"

namespace symplant::description {

/// Where a value of a description is written.
struct Origin {
  std::size_t file = 0;  ///< index in PlantSource::files()
  std::string pointer;   ///< in that file
  /// Members of an object or array that are written elsewhere than in its file: by their key in a pointer.
  std::map<std::string, Origin, std::less<>> members = {};

  /// Of a member, by its key in a pointer.
  Origin member(const std::string& key) const;
};

/// The files of a description, and where its values are in them. Pointers are those of the whole description.
class PlantSource {
 public:
  /// A description of one file.
  explicit PlantSource(std::shared_ptr<const text::SourceFile> file);
  /// The plant.json comes first in `files`.
  PlantSource(std::vector<std::shared_ptr<const text::SourceFile>> files, Origin root);

  /// Of the plant.json.
  const std::string& path() const { return files_.front()->path(); }
  /// The plant.json, then the included ones in the order in which they are first included.
  std::span<const std::shared_ptr<const text::SourceFile>> files() const { return files_; }
  std::vector<std::string> paths() const;
  /// The file and the pointer in it. If the description lacks the value, those of its nearest parent or below.
  Origin origin(std::string_view pointer) const;
  /// The folder of the file with a value: what the paths in it are relative to.
  std::string folder(std::string_view pointer) const;

  /// A span in one of the files.
  struct Place {
    std::size_t file = 0;
    json::Span span;
    bool operator<(const Place& other) const {
      return file != other.file ? file < other.file : span.begin < other.span.begin;
    }
  };
  /// As json::locate(), with one pass over each file.
  std::vector<Place> places(std::span<const json::Fault> values) const;
  diag::Location location(const Place& place) const { return {files_[place.file], {place.span.begin, place.span.end}}; }

 private:
  std::vector<std::shared_ptr<const text::SourceFile>> files_;
  Origin root_;
};

/// Sorts entries of the object at `pointer`, by their names, as the description has them.
template <class Entry>
void sort_as_written(std::vector<Entry>& entries, std::string_view pointer, const PlantSource& source) {
  if (entries.size() < 2) return;
  std::vector<json::Fault> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.push_back({json::child(pointer, entry.name), {}});
  const std::vector<PlantSource::Place> places = source.places(names);
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  std::vector<Entry> sorted;
  sorted.reserve(entries.size());
  for (const std::size_t i : order) sorted.push_back(std::move(entries[i]));
  entries = std::move(sorted);
}

}  // namespace symplant::description
