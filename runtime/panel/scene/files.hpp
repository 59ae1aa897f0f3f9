// The pictures and models of the panel, in files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/panel/answer.hpp"
#include "symplant/panel/web/content.hpp"

namespace symplant::panel {

/// The largest file, in bytes.
inline constexpr std::size_t kMostFileBytes = std::size_t{32} << 20;
/// The files that are kept in memory, in bytes.
inline constexpr std::size_t kMostKept = 2 * kMostFileBytes;

/// Files of some folders by their plain names: `.svg`, `.png` and `.glb`, no others. For one thread.
class SceneFiles {
 public:
  /// In the order in which they are searched; empty ones are left out.
  explicit SceneFiles(std::vector<std::string> folders);

  /// The first 1000 names, sorted, as the answer to GET /api/v1/files. O(files of the folders).
  std::string list() const;

  /// A file that is the same for all clients, or the answer that refuses it: 404, or 422 if it is too large or cannot
  /// be read. It is read again if it has changed. O(its size), O(1) while it does not change.
  std::variant<std::shared_ptr<Content>, Answer> read(std::string_view name);

 private:
  struct Kept {
    std::string path;
    std::filesystem::file_time_type changed;
    std::uintmax_t size = 0;
    std::shared_ptr<Content> content;
  };
  std::variant<std::shared_ptr<Content>, Answer> read_from(const std::string& name, const std::filesystem::path& path,
                                                           std::string_view type);

  std::vector<std::string> folders_;
  std::map<std::string, Kept, std::less<>> kept_;  ///< by name; at most kMostKept bytes
};

}  // namespace symplant::panel
