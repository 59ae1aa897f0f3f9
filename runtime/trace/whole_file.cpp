// Replaces a file as a whole: it has the new contents, or still the old ones.
#include "symplant/trace/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace symplant::trace {
namespace {

/// A rename would replace a device or a pipe.
bool is_replaced(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

/// The reason of a failure, or an empty text.
std::string write(const std::string& path, std::string_view bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? "" : std::strerror(errno);
}

}  // namespace

std::string write_whole_file(const std::string& path, std::string_view bytes) {
  if (!is_replaced(path)) return write(path, bytes);
  const std::string part_path = path + ".part";
  std::string failure = write(part_path, bytes);
  std::error_code error;
  if (failure.empty()) std::filesystem::rename(part_path, path, error);
  if (error) failure = error.message();
  if (!failure.empty()) std::remove(part_path.c_str());
  return failure;
}

}  // namespace symplant::trace
