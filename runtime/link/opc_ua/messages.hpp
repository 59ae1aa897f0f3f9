// Messages of a link to the user, from its thread.
#pragma once

#include <cstddef>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symplant::link::opc_ua {

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
