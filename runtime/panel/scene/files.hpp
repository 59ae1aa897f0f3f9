// The pictures and models of the panel, in files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/panel/answer.hpp"

namespace symplant::panel {

/// The largest file, in bytes.
inline constexpr std::size_t kMostFileBytes = std::size_t{32} << 20;

/// Files of some folders by their plain names: `.svg`, `.png` and `.glb`, no others. Several threads may use it.
class SceneFiles {
 public:
  /// In the order in which they are searched; empty ones are left out.
  explicit SceneFiles(std::vector<std::string> folders);

  /// The first 1000 names, sorted, as the answer to GET /api/v1/files. O(files of the folders).
  std::string list() const;

  struct File {
    std::string bytes;
    std::string_view type;  ///< its Content-Type
  };
  /// A file, or why there is none: 404, or 422 if it is too large or cannot be read. O(its size).
  std::variant<File, Answer> read(std::string_view name) const;

 private:
  std::vector<std::string> folders_;
};

}  // namespace symplant::panel
