// Replaces a file with a new one once the new one is complete.
#include "base/replacement.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "base/disk.hpp"

namespace symplant::base {

namespace fs = std::filesystem;

NewFile::~NewFile() {
  if (!path_.empty()) disk::remove(path_);
}

int NewFile::open(const fs::path& folder) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    path_ = (folder / (".symplant-" + std::to_string(disk::process_number()) + "-" + std::to_string(attempt) + ".tmp"))
                .string();
    file_ = Descriptor(disk::open_new(path_));
    if (file_) return 0;
    path_.clear();
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

int NewFile::finish(std::optional<unsigned> permissions) {
  const int fault = permissions ? disk::set_permissions(file_.number(), *permissions) : 0;
  if (fault != 0) return fault;
  return file_.close() ? 0 : errno;
}

int NewFile::replace(const fs::path& target) {
  const int fault = disk::rename_over(path_, target.string());
  if (fault == 0) path_.clear();
  return fault;
}

int NewFile::appear_as(const fs::path& target) { return disk::rename_new(path_, target.string()); }

Replacement::Replacement(const std::string& path, std::optional<unsigned> permissions)
    : permissions_(permissions), old_(permissions ? disk::open_to_read(path) : -1) {
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
  if (failure) return failure.default_error_condition().value();
  const int fault = made_.open(folder);
  if (fault != 0 || equal_ == 0) return fault;
  if (const int failed = disk::rewind(old_.number()); failed != 0) return failed;
  std::array<char, 64 * 1024> part{};
  for (std::size_t left = equal_; left != 0;) {
    const std::ptrdiff_t count = read_full(old_.number(), part.data(), std::min(left, part.size()));
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
  if (fault_ == 0) fault_ = made_.finish(permissions_);
  old_.close();  // Windows replaces no open file
  if (fault_ == 0) fault_ = made_.replace(target_);
  if (fault_ != 0) changed_ = false;
  return fault_;
}

}  // namespace symplant::base
