// Converts paths of files to URIs.
#include "diag/uri.hpp"

#include <filesystem>

namespace symplant::diag {
namespace {

namespace fs = std::filesystem;

bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

std::string percent_encoded(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const char c : bytes) {
    if (is_plain(c)) {
      text += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    text.append("%").append(1, kDigits[byte / 16]).append(1, kDigits[byte % 16]);
  }
  return text;
}

/// `/a`, and of Windows `C:/a`.
std::string absolute_uri(const fs::path& file) {
  const std::string drive = file.root_name().generic_string();
  const std::string rest = percent_encoded(file.generic_string().substr(drive.size()));
  return (drive.empty() ? "file://" : "file:///" + drive) + rest;
}

}  // namespace

std::string file_uri(std::string_view path, std::string_view folder) {
  fs::path file = fs::path(path).lexically_normal();
  if (!file.has_root_directory()) return percent_encoded(file.generic_string());
  if (!file.has_root_name()) file = fs::path(folder).root_name() / file;  // the drive, on Windows
  const fs::path inside = folder.empty() ? fs::path() : file.lexically_relative(fs::path(folder).lexically_normal());
  if (!inside.empty() && *inside.begin() != "..") return percent_encoded(inside.generic_string());
  return absolute_uri(file);
}

}  // namespace symplant::diag
