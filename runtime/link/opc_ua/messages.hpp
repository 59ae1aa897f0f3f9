// Messages of a link to the user, from its thread.
#pragma once

#include <algorithm>
#include <array>
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

/// For any thread except that of the cycle. Of what clients can cause, at most kMost messages of each cause are
/// reported.
class Messages {
 public:
  static constexpr std::size_t kMost = 50;

  /// What a client does.
  enum class Cause { user, certificate, malfunction, freeze };

  void add(std::string text) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(text));
  }
  /// A message on what a client did.
  void add(Cause cause, const std::string& text) {
    const std::lock_guard lock(mutex_);
    add_limited(of_causes_[static_cast<std::size_t>(cause)], text);
  }
  /// The same; a text that was added before is not reported again.
  void add_once(Cause cause, const std::string& text) {
    const std::lock_guard lock(mutex_);
    OfCause& of = of_causes_[static_cast<std::size_t>(cause)];
    if (of.count <= kMost && of.once.insert(text).second) add_limited(of, text);
  }
  std::vector<std::string> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  static constexpr std::size_t kCauses = 4;
  struct OfCause {
    std::size_t count = 0;
    std::set<std::string> once;
  };

  void add_limited(OfCause& of, const std::string& text) {
    if (of.count > kMost) return;
    waiting_.push_back(++of.count <= kMost ? text : text + "; further messages of this kind are not reported");
  }

  std::mutex mutex_;
  std::vector<std::string> waiting_;
  std::array<OfCause, kCauses> of_causes_;
};

}  // namespace symplant::link::opc_ua
