// Files by POSIX.
#include "base/disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace symplant::base::disk {
namespace {

About about(const struct stat& found) {
  const Kind kind = S_ISREG(found.st_mode) ? Kind::regular : S_ISDIR(found.st_mode) ? Kind::folder : Kind::other;
  return {kind, static_cast<std::uint64_t>(found.st_size), found.st_mode & 07777U, 0};
}

}  // namespace

About about(const std::string& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0 ? about(found) : About{.fault = errno};
}

About about(int file) {
  struct stat found {};
  return ::fstat(file, &found) == 0 ? about(found) : About{.fault = errno};
}

bool exists(const std::string& path) {
  struct stat found {};
  return ::lstat(path.c_str(), &found) == 0;
}

int open_to_read(const std::string& path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }
int open_to_write(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }
int open_new(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); }

std::ptrdiff_t read(int file, char* bytes, std::size_t size) {
  for (;;) {
    const ssize_t count = ::read(file, bytes, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

std::ptrdiff_t write(int file, const char* bytes, std::size_t size) {
  for (;;) {
    const ssize_t count = ::write(file, bytes, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

int rewind(int file) { return ::lseek(file, 0, SEEK_SET) == 0 ? 0 : errno; }
int close(int file) { return ::close(file) == 0 ? 0 : errno; }
int set_permissions(int file, unsigned permissions) { return ::fchmod(file, permissions) == 0 ? 0 : errno; }

int rename_over(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

// Unlike rename(), link() replaces nothing. The first name is removed later.
int rename_new(const std::string& from, const std::string& to) {
  return ::link(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

void remove(const std::string& path) { ::unlink(path.c_str()); }

unsigned long process_number() { return static_cast<unsigned long>(::getpid()); }

}  // namespace symplant::base::disk
