// Replaces a file with a new one once the new one is complete.
#include "base/replacement.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

namespace symplant::base {

namespace fs = std::filesystem;

NewFile::~NewFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

int NewFile::open(const fs::path& folder) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    path_ = (folder / (".symplant-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp")).string();
    file_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file_) return 0;
    path_.clear();
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

int NewFile::finish(std::optional<mode_t> mode) {
  if (mode && ::fchmod(file_.number(), *mode) != 0) return errno;
  return file_.close() ? 0 : errno;
}

int NewFile::replace(const fs::path& target) {
  if (std::rename(path_.c_str(), target.c_str()) != 0) return errno;
  path_.clear();
  return 0;
}

int NewFile::link_as(const fs::path& target) { return ::link(path_.c_str(), target.c_str()) == 0 ? 0 : errno; }

Replacement::Replacement(const std::string& path, std::optional<mode_t> mode)
    : mode_(mode), old_(mode ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1) {
  std::error_code failure;
  target_ = fs::canonical(path, failure);
  if (failure) target_ = path;
}

void Replacement::put(std::string_view part) {
  if (fault_ != 0) return;
  if (!made_.is_open()) {
    if (old_ && holds_next(old_.number(), part)) {
      equal_ += part.size();
      return;
    }
    fault_ = begin();
  }
  if (fault_ == 0) fault_ = made_.append(part);
}

int Replacement::begin() {
  changed_ = true;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return failure.value();
  const int fault = made_.open(folder);
  if (fault != 0 || equal_ == 0) return fault;
  if (::lseek(old_.number(), 0, SEEK_SET) != 0) return errno;
  std::array<char, 64 * 1024> part{};
  for (std::size_t left = equal_; left != 0;) {
    const ssize_t count = read_full(old_.number(), part.data(), std::min(left, part.size()));
    if (count <= 0) return count < 0 ? errno : EIO;  // the file became shorter in the meantime
    if (const int failed = made_.append({part.data(), static_cast<std::size_t>(count)}); failed != 0) return failed;
    left -= static_cast<std::size_t>(count);
  }
  return 0;
}

int Replacement::finish() {
  if (fault_ == 0 && !made_.is_open()) {
    if (old_ && ends_here(old_.number())) return 0;
    fault_ = begin();
  }
  if (fault_ == 0) fault_ = made_.finish(mode_);
  if (fault_ == 0) fault_ = made_.replace(target_);
  if (fault_ != 0) changed_ = false;
  return fault_;
}

}  // namespace symplant::base
