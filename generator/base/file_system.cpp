// The machine's own files.
#include "base/file_system.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace symplant::base {

namespace {

/// Owns a descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }
  /// False where the system kept an error of a write until now.
  bool close() {
    const int closing = std::exchange(number_, -1);
    return closing < 0 || ::close(closing) == 0;
  }

 private:
  int number_;
};

std::string reason(int code) {
  switch (code) {
    case ENOENT:
      return "there is no such file or folder";
    case EACCES:
    case EPERM:
      return "no permission";
    case EISDIR:
      return "it is a directory; give a file";
    case ENOTDIR:
      return "a part of its path is no folder";
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

FileError error_of(std::string_view act, const std::string& path, int code) {
  return {"cannot " + std::string(act) + " `" + path + "`: " + reason(code)};
}

/// 0, or why not all could be written.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Writes to what is no plain file (a pipe, /dev/stdout): it is there to be written to, not to be replaced.
int write_through(const std::string& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file) return errno;
  const int fault = write_all(file.number(), content);
  return fault == 0 && !file.close() ? errno : fault;
}

/// Writes a new file in `folder`, whose name comes back in `temporary`. 0 or why not; then nothing is left behind.
int write_beside(const std::filesystem::path& folder, mode_t mode, std::string_view content, std::string& temporary) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary =
        (folder / (".symplant-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp")).string();
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file && errno == EEXIST) continue;
    if (!file) return errno;
    int fault = write_all(file.number(), content);
    if (fault == 0 && mode != 0 && ::fchmod(file.number(), mode) != 0) fault = errno;
    if (!file.close() && fault == 0) fault = errno;
    if (fault != 0) ::unlink(temporary.c_str());
    return fault;
  }
  return EEXIST;
}

/// 0, or why `path` could not be made to hold `content`. A link stays a link: what it points to is replaced.
int replace(const std::string& path, mode_t mode, std::string_view content) {
  std::error_code failure;
  std::filesystem::path target = std::filesystem::canonical(path, failure);
  if (failure) target = path;
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  std::filesystem::create_directories(folder, failure);
  if (failure) return failure.value();
  std::string temporary;
  int fault = write_beside(folder, mode, content, temporary);
  if (fault == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) {
    fault = errno;
    ::unlink(temporary.c_str());
  }
  return fault;
}

}  // namespace

Result<std::string, FileError> DiskFileSystem::read(const std::string& path) const {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return error_of("read", path, errno);
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) return error_of("read", path, errno);
  if (S_ISDIR(about.st_mode)) return error_of("read", path, EISDIR);
  constexpr std::size_t kAtLeast = 64 * 1024;
  std::string content;
  std::size_t filled = 0;
  // One byte more than the size, so that the end of the file shows without growing.
  content.resize(S_ISREG(about.st_mode) ? static_cast<std::size_t>(about.st_size) + 1 : kAtLeast);
  for (;;) {
    if (filled == content.size()) content.resize(content.size() * 2 + kAtLeast);
    const ssize_t count = ::read(file.number(), content.data() + filled, content.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return error_of("read", path, errno);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  content.resize(filled);
  return content;
}

Result<bool, FileError> DiskFileSystem::write(const std::string& path, std::string_view content) {
  struct stat about {};
  const bool exists = ::stat(path.c_str(), &about) == 0;
  if (exists && S_ISDIR(about.st_mode)) return error_of("write", path, EISDIR);
  if (exists && !S_ISREG(about.st_mode)) {
    const int fault = write_through(path, content);
    if (fault != 0) return error_of("write", path, fault);
    return true;
  }
  if (exists && static_cast<std::size_t>(about.st_size) == content.size()) {
    const auto old = read(path);
    if (old && *old == content) return false;
  }
  const int fault = replace(path, exists ? about.st_mode & 07777U : 0, content);
  if (fault != 0) return error_of("write", path, fault);
  return true;
}

Result<bool, FileError> DiskFileSystem::write_new(const std::string& path, std::string_view content) {
  if (exists(path)) return false;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failure;
  if (!folder.empty()) std::filesystem::create_directories(folder, failure);
  if (failure) return error_of("write", path, failure.value());
  std::string temporary;
  int fault = write_beside(folder.empty() ? "." : folder, 0, content, temporary);
  if (fault != 0) return error_of("write", path, fault);
  const bool made = ::link(temporary.c_str(), path.c_str()) == 0;  // unlike a rename it replaces nothing
  fault = made ? 0 : errno;
  ::unlink(temporary.c_str());
  if (fault != 0 && fault != EEXIST) return error_of("write", path, fault);
  return made;
}

bool DiskFileSystem::exists(const std::string& path) const {
  struct stat about {};
  return ::lstat(path.c_str(), &about) == 0;
}

}  // namespace symplant::base
