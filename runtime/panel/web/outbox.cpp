// The texts that a connection still has to send.
#include "symplant/panel/web/outbox.hpp"

#include <utility>

namespace symplant::panel::web {

void Outbox::add(Bytes bytes) {
  if (bytes->empty()) return;
  size_ += bytes->size();
  texts_.push_back(std::move(bytes));
}

void Outbox::drop() {
  if (texts_.empty()) return;
  texts_.resize(1);
  size_ = next().size();
}

void Outbox::taken(std::size_t count) {
  size_ -= count;
  begun_ += count;
  if (begun_ != texts_.front()->size()) return;
  texts_.pop_front();
  begun_ = 0;
}

}  // namespace symplant::panel::web
