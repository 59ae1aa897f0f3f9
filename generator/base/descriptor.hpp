// An owned file descriptor, and reading and writing through it.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <utility>

#include "base/disk.hpp"

namespace symplant::base {

/// Owns a file descriptor and closes it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}  ///< below 0: not open
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }

  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }
  /// False if the system reports an error of an earlier write.
  bool close() {
    const int closing = std::exchange(number_, -1);
    return closing < 0 || disk::close(closing) == 0;
  }

 private:
  int number_;
};

/// Writes all of `content`. Returns 0 or errno.
inline int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const std::ptrdiff_t count = disk::write(descriptor, content.data(), content.size());
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Reads until the buffer is full. Returns the number of bytes, less than `size` only at the end of the file; -1 on
/// failure.
inline std::ptrdiff_t read_full(int descriptor, char* buffer, std::size_t size) {
  std::size_t filled = 0;
  while (filled < size) {
    const std::ptrdiff_t count = disk::read(descriptor, buffer + filled, size - filled);
    if (count < 0) return -1;
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return static_cast<std::ptrdiff_t>(filled);
}

/// Reads the next bytes of a file and returns whether they equal `bytes`.
inline bool holds_next(int descriptor, std::string_view bytes) {
  std::array<char, 64 * 1024> there;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled before it is read
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), there.size());
    if (read_full(descriptor, there.data(), size) != static_cast<std::ptrdiff_t>(size)) return false;
    if (std::string_view(there.data(), size) != bytes.substr(0, size)) return false;
    bytes.remove_prefix(size);
  }
  return true;
}

inline bool ends_here(int descriptor) {
  char more = 0;
  return read_full(descriptor, &more, 1) == 0;
}

}  // namespace symplant::base
