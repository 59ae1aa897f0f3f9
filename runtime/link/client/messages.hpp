// Messages of a link's thread to the user.
#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace symplant::link::client {

/// Holds messages until they are taken. Any thread; not for the cycle's thread, since it locks.
class Messages {
 public:
  /// Ignored if it is equal to the one before it, taken or not.
  void add(std::string text) {
    const std::scoped_lock lock(mutex_);
    if (text == last_) return;
    last_ = text;
    waiting_.push_back(std::move(text));
  }
  std::vector<std::string> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  std::mutex mutex_;
  std::string last_;
  std::vector<std::string> waiting_;
};

}  // namespace symplant::link::client
