// The texts that a connection still has to send.
#pragma once

#include <cstddef>
#include <deque>
#include <string_view>

#include "symplant/panel/web/content.hpp"

namespace symplant::panel::web {

/// Texts that are sent one after the other, in pieces of any size. For one thread.
class Outbox {
 public:
  void add(Bytes bytes);
  /// Forgets all texts but the first, which may be half sent.
  void drop();
  bool empty() const { return texts_.empty(); }
  /// The bytes that wait.
  std::size_t size() const { return size_; }
  /// The rest of the first text; it is valid until taken() has reached its end.
  std::string_view next() const { return std::string_view(*texts_.front()).substr(begun_); }
  /// The first `count` bytes of next() were taken.
  void taken(std::size_t count);

 private:
  std::deque<Bytes> texts_;
  std::size_t begun_ = 0;  ///< the bytes of the first text that were taken
  std::size_t size_ = 0;
};

}  // namespace symplant::panel::web
