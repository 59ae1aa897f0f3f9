// Whether a PLC is connected.
#include "symplant/link/health.hpp"

namespace symplant::link {

using exec::LinkState;

Verdict LinkHealth::look(tables::Time now, bool heard, bool complete) noexcept {
  const bool was_silent = state_ == LinkState::waiting || (state_ == LinkState::lost && !returning_);
  if (heard) heard_ = now;
  if (was_silent && !heard) return Verdict::hold;
  if (state_ == LinkState::waiting) {
    state_ = LinkState::live;
    return Verdict::apply;
  }
  if (was_silent) {
    returning_ = true;
    returned_ = now;
  }
  if (now - heard_ >= loss_after_) {
    state_ = LinkState::lost;
    returning_ = false;
    ++losses_;
    return Verdict::lose;
  }
  if (state_ == LinkState::live) return Verdict::apply;
  if (!complete && now - returned_ < resync_) return Verdict::hold;
  state_ = LinkState::live;
  returning_ = false;
  return Verdict::apply;
}

}  // namespace symplant::link
