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

}  // namespace

std::string file_uri(std::string_view path, std::string_view folder) {
  fs::path file = fs::path(path).lexically_normal();
  if (file.is_relative()) return percent_encoded(file.generic_string());
  const fs::path inside = folder.empty() ? fs::path() : file.lexically_relative(fs::path(folder).lexically_normal());
  if (!inside.empty() && *inside.begin() != "..") return percent_encoded(inside.generic_string());
  return "file://" + percent_encoded(file.generic_string());
}

}  // namespace symplant::diag
