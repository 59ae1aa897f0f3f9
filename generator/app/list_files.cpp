// The files that an entry of `symbols` names.
#include "app/list_files.hpp"

#include <algorithm>
#include <filesystem>

#include "text/pattern.hpp"

namespace symplant::app {
namespace {

namespace fs = std::filesystem;

/// The folders or files below each of `folders` that match one part of a path.
std::vector<fs::path> matching(const std::vector<fs::path>& folders, const std::string& part,
                               const base::FileSystem& files) {
  std::vector<fs::path> found;
  for (const fs::path& folder : folders) {
    if (!text::is_pattern(part)) {
      found.push_back(folder / part);
      continue;
    }
    for (const std::string& name : files.list(folder.empty() ? "." : folder.generic_string())) {
      if (!name.starts_with('.') && text::matches_pattern(name, part)) found.push_back(folder / name);
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> list_files(const std::string& path, const base::FileSystem& files) {
  if (!text::is_pattern(path)) return {path};
  std::vector<fs::path> found{fs::path()};
  for (const fs::path& part : fs::path(path)) found = matching(found, part.generic_string(), files);
  std::vector<std::string> paths;
  for (const fs::path& file : found) {
    if (files.exists(file.generic_string())) paths.push_back(file.generic_string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace symplant::app
