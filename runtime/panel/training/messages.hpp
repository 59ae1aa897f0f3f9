// What the trainer writes to all browsers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::panel {

/// What is wrong with a text that is_message() does not accept.
inline constexpr std::string_view kMessageForm =
    "`message` is a text of 1 to 500 characters, without control characters other than newlines, and not only blanks";

/// Whether a text can be a message. O(text).
bool is_message(std::string_view utf8);

/// The messages of a run. A reset or a restore does not remove them. Used by one thread at a time.
class Messages {
 public:
  static constexpr std::size_t kMost = 50;  ///< that are kept

  void add(tables::Time now, std::string text);
  /// Appends the messages from number `from` on as an array, as far as they are kept.
  void put(std::string& json, std::uint64_t from) const;
  /// The number of messages so far.
  std::uint64_t count() const { return first_ + all_.size(); }

 private:
  struct Message {
    tables::Time time;
    std::string text;
  };
  std::deque<Message> all_;
  std::uint64_t first_ = 0;
};

}  // namespace symplant::panel
