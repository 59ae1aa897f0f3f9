// Whether a PLC is connected: when its link is lost, and when its operations apply again.
#pragma once

#include "symplant/exec/exchange.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link {

/// What the cycle does with the operations of a link.
enum class Verdict : std::uint8_t {
  apply,  ///< apply what the PLC wrote
  lose,   ///< the link is lost from now on: apply its policy
  hold,   ///< do not apply what the PLC wrote
};

/// The state of one link that serves a PLC. The link waits for the first valid request that touches the map. It is lost
/// when no such request has come for `loss_after`. When one comes again, writes are collected until everything written
/// before the loss has been written again, for at most `resync`. Times are those of cycles, so their resolution is one
/// cycle. Used by the thread of the cycle; O(1).
class LinkHealth {
 public:
  LinkHealth(tables::Time loss_after, tables::Time resync) noexcept : loss_after_(loss_after), resync_(resync) {}

  /// To be called once per cycle. `heard`: a valid request that touches the map has come since the last call;
  /// `complete`: everything written before the loss has been written again.
  Verdict look(tables::Time now, bool heard, bool complete) noexcept;

  exec::LinkState state() const noexcept { return state_; }
  /// Number of losses.
  std::uint32_t losses() const noexcept { return losses_; }

 private:
  tables::Time loss_after_;
  tables::Time resync_;
  exec::LinkState state_ = exec::LinkState::waiting;
  bool returning_ = false;  ///< lost, but requests come again
  tables::Time heard_ = 0;  ///< time of the last request
  tables::Time returned_ = 0;
  std::uint32_t losses_ = 0;
};

}  // namespace symplant::link
