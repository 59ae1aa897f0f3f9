// A file descriptor with an owner, for what writes files.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <utility>

namespace symplant::base {

/// Closes it in the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}  ///< below 0: none
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }

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

/// 0, or why not all could be written.
inline int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// How much was read into the buffer: less than its size at the end of the file only; below 0 where reading failed.
inline ssize_t read_full(int descriptor, char* buffer, std::size_t size) {
  std::size_t filled = 0;
  while (filled < size) {
    const ssize_t count = ::read(descriptor, buffer + filled, size - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return static_cast<ssize_t>(filled);
}

/// Whether the next bytes of a file are these; it then stands behind them.
inline bool holds_next(int descriptor, std::string_view bytes) {
  std::array<char, 64 * 1024> there;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled before it is read
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), there.size());
    if (read_full(descriptor, there.data(), size) != static_cast<ssize_t>(size)) return false;
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
