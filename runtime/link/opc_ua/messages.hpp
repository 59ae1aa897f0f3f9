// Messages of a link to the user, from its thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace symplant::link::opc_ua {

/// A text that a client or server sent, for a message: its first 100 bytes, without control characters.
inline std::string of_peer(std::string_view text) {
  constexpr std::size_t kMost = 100;
  std::string shown(text.substr(0, kMost));
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; };
  std::replace_if(shown.begin(), shown.end(), is_control, '?');
  return shown;
}

/// For any thread except that of the cycle. What clients can cause is reported once for each text, and at most
/// kMostOnce texts of them.
class Messages {
 public:
  static constexpr std::size_t kMostOnce = 50;

  void add(std::string text) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(text));
  }
  void add_once(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (once_.size() < kMostOnce && once_.insert(text).second) waiting_.push_back(text);
  }
  std::vector<std::string> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> waiting_;
  std::set<std::string> once_;
};

}  // namespace symplant::link::opc_ua
