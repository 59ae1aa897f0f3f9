// Files on the disk of the machine.
#include "base/file_system.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/descriptor.hpp"
#include "base/disk.hpp"
#include "base/large_memory.hpp"
#include "base/replacement.hpp"

namespace symplant::base {

namespace {

std::string reason(int code) {
  switch (code) {
    case ENOENT:
      return "there is no such file or folder";
    case EACCES:
    case EPERM:
      return "no permission";
    case EISDIR:
      return "it is a directory";
    case ENOTDIR:
      return "a part of its path is not a folder";
    case ENOSPC:
      return "no space is left on the disk";
    case EROFS:
      return "the file system is read-only";
    case ENAMETOOLONG:
      return "its name is too long";
    default:
      return std::generic_category().message(code);
  }
}

/// The commonest ending of the files in a folder, `.xml`; empty without one.
std::string commonest_ending(const std::string& folder) {
  std::map<std::string, std::size_t> counts;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored)) ++counts[entry.path().extension().generic_string()];
  }
  counts.erase("");
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? "" : most->first;
}

FileError error_of(std::string_view act, const std::string& path, int code) {
  std::string message = "cannot " + std::string(act) + " `" + path + "`: " + reason(code);
  if (code != EISDIR) return {std::move(message)};
  const std::string ending = act == "read" ? commonest_ending(path) : "";
  if (ending.empty()) return {message + "; give a file"};
  return {message + "; give the files in it, such as `" +
          (std::filesystem::path(path) / ("*" + ending)).generic_string() + "`"};
}

/// Writes to what is not a regular file (a pipe, /dev/stdout), which must not be replaced.
class Through final : public TextSink {
 public:
  explicit Through(const std::string& path) : file_(disk::open_to_write(path)) {
    if (!file_) fault_ = errno;
  }
  void put(std::string_view part) override {
    if (fault_ == 0) fault_ = write_all(file_.number(), part);
  }
  int finish() { return fault_ == 0 && !file_.close() ? errno : fault_; }

 private:
  Descriptor file_;
  int fault_ = 0;
};

/// Compares a file with a text.
class Comparison final : public TextSink {
 public:
  explicit Comparison(int descriptor) : descriptor_(descriptor) {}
  void put(std::string_view part) override { equal_ = equal_ && holds_next(descriptor_, part); }
  bool finish() { return equal_ && ends_here(descriptor_); }

 private:
  int descriptor_;
  bool equal_ = true;
};

}  // namespace

Result<std::string, FileError> DiskFileSystem::read(const std::string& path) const {
  const Descriptor file(disk::open_to_read(path));
  if (!file) return error_of("read", path, errno);
  const disk::About about = disk::about(file.number());
  if (about.kind == disk::Kind::absent) return error_of("read", path, about.fault);
  if (about.kind == disk::Kind::folder) return error_of("read", path, EISDIR);
  const bool has_size = about.kind == disk::Kind::regular;
  constexpr std::size_t kMostOfAStream = std::size_t{256} << 20U;  // of a file without a size: a pipe, /dev/zero
  std::string content;
  if (has_size) reserve_large(content, static_cast<std::size_t>(about.size));
  // Through a buffer that stays in the cache: a string of the size would be filled with zeros first.
  std::vector<char> buffer(std::size_t{256} << 10U);
  for (;;) {
    if (!has_size && content.size() > kMostOfAStream) {
      return FileError{"cannot read `" + path + "`: more than 256 MB came from it and it has no end; give a file"};
    }
    const std::ptrdiff_t count = disk::read(file.number(), buffer.data(), buffer.size());
    if (count < 0) return error_of("read", path, errno);
    if (count == 0) break;
    content.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return content;
}

Result<bool, FileError> DiskFileSystem::write(const std::string& path, std::string_view content) {
  return write_made(path, [content](TextSink& sink) { sink.put(content); });
}

Result<bool, FileError> DiskFileSystem::write_made(const std::string& path, const TextSource& content) {
  const disk::About about = disk::about(path);
  if (about.kind == disk::Kind::folder) return error_of("write", path, EISDIR);
  if (about.kind == disk::Kind::other) {
    Through through(path);
    content(through);
    const int fault = through.finish();
    if (fault != 0) return error_of("write", path, fault);
    return true;
  }
  Replacement replacement(path, about.kind == disk::Kind::regular ? std::optional(about.permissions) : std::nullopt);
  content(replacement);
  const int fault = replacement.finish();
  if (fault != 0) return error_of("write", path, fault);
  return replacement.changed();
}

bool DiskFileSystem::holds(const std::string& path, const TextSource& content) const {
  const Descriptor file(disk::open_to_read(path));
  if (!file) return false;
  Comparison comparison(file.number());
  content(comparison);
  return comparison.finish();
}

Result<bool, FileError> DiskFileSystem::write_new(const std::string& path, std::string_view content) {
  if (exists(path)) return false;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failure;
  if (!folder.empty()) std::filesystem::create_directories(folder, failure);
  if (failure) return error_of("write", path, failure.default_error_condition().value());
  NewFile made;
  int fault = made.open(folder.empty() ? "." : folder);
  if (fault == 0) fault = made.append(content);
  if (fault == 0) fault = made.finish({});
  if (fault == 0) fault = made.appear_as(path);
  if (fault == EEXIST) return false;
  if (fault != 0) return error_of("write", path, fault);
  return true;
}

std::vector<std::string> DiskFileSystem::list(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code failure;
  for (std::filesystem::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    names.push_back(at->path().filename().generic_string());
  }
  return names;
}

bool DiskFileSystem::exists(const std::string& path) const { return disk::exists(path); }

}  // namespace symplant::base
