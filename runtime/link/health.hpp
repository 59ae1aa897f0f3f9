// Whether a PLC is there: when its link counts as lost, and when what it wrote counts again.
#pragma once

#include "symplant/exec/exchange.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link {

/// What the cycle is to do with the operations of a link.
enum class Verdict : std::uint8_t {
  apply,  ///< what the PLC wrote acts
  lose,   ///< the link is lost from now on: its policy acts
  hold,   ///< what the PLC wrote does not act now
};

/// Of one link of which the plant is the server. It waits for the first valid request that touches the map; it is lost
/// when none has come for `loss_after`; when one comes again, writes are collected until all is there that was
/// written before the loss, at the longest for `resync`. Times are the cycle's, so nothing is known more finely than a
/// cycle. Used by the thread of the cycle; O(1).
class LinkHealth {
 public:
  LinkHealth(tables::Time loss_after, tables::Time resync) noexcept : loss_after_(loss_after), resync_(resync) {}

  /// Once a cycle. `heard`: a valid request that touches the map came since the last call; `complete`: all that was
  /// written before the loss has been written again.
  Verdict look(tables::Time now, bool heard, bool complete) noexcept;

  exec::LinkState state() const noexcept { return state_; }
  /// How often it was lost.
  std::uint32_t losses() const noexcept { return losses_; }

 private:
  tables::Time loss_after_;
  tables::Time resync_;
  exec::LinkState state_ = exec::LinkState::waiting;
  bool returning_ = false;  ///< lost, but heard again
  tables::Time heard_ = 0;  ///< last
  tables::Time returned_ = 0;
  std::uint32_t losses_ = 0;
};

}  // namespace symplant::link
