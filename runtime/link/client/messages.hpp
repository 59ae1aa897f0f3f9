// Messages of a link's thread to the user.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symplant::link::client {

/// Holds messages until they are taken. Any thread; not for the cycle's thread, since it locks.
class Messages {
 public:
  /// Adds a message. Ignored if the same text was added since the last forget(), so that a lasting problem is reported
  /// once.
  void add(std::string text) {
    const std::scoped_lock lock(mutex_);
    if (text.empty() || !added_.insert(text).second) return;
    waiting_.push_back(std::move(text));
  }
  /// Accepts the messages again that were added before.
  void forget() {
    const std::scoped_lock lock(mutex_);
    added_.clear();
  }
  std::vector<std::string> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  std::mutex mutex_;
  std::set<std::string> added_;
  std::vector<std::string> waiting_;
};

}  // namespace symplant::link::client
