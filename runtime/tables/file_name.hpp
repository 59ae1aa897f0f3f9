// Names of files in a folder that users give.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace symplant::tables {

/// Whether a text is the name of a file in a folder, not a path: 1 to 64 letters, digits, blanks, `_`, `-`, `.`, the
/// first one not a `.` or a blank.
constexpr bool is_file_name(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_' ||
           c == '-' || c == '.';
  };
  return !name.empty() && name.size() <= kLongest && name.front() != '.' && name.front() != ' ' &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

/// What is_file_name() asks for, for messages.
inline constexpr const char* kFileNameForm =
    "1 to 64 letters, digits, blanks, `_`, `-` or `.`, and does not begin with a `.` or a blank";

/// Whether it names a picture of the panel's plan: `.svg` or `.png`.
constexpr bool is_picture_name(std::string_view name) {
  return is_file_name(name) && (name.ends_with(".svg") || name.ends_with(".png"));
}

/// Whether it names a model of the panel's 3D view: `.glb`.
constexpr bool is_model_name(std::string_view name) { return is_file_name(name) && name.ends_with(".glb"); }

}  // namespace symplant::tables
