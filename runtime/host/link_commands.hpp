// Carries out the commands that clients of links give to a run.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/exec/stepper.hpp"
#include "symplant/host/links.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::host {

/// A stepper that carries out the commands of links at the beginning of each cycle, and otherwise passes everything on:
/// to another stepper, or to the plant. A malfunction starts or ends at the plant's time, in a further instant. Used by
/// the thread of the cycle; a cycle without a command costs two calls for each link. Real-time safe.
class LinkCommands final : public exec::Stepper {
 public:
  /// `stepper` may be null. The references must outlive this.
  LinkCommands(const Links& links, plant::Plant& plant, trace::Recorder& recorder, exec::Stepper* stepper);

  /// Whether a link of the run may give commands.
  bool empty() const noexcept { return links_.empty(); }

  void advance_to(tables::Time time) noexcept override;
  void hold() noexcept override;
  bool frozen() const noexcept override { return frozen_ || frozen_otherwise(); }
  bool over() const noexcept override { return stepper_ != nullptr && stepper_->over(); }
  bool failed() const noexcept override { return stepper_ != nullptr && stepper_->failed(); }

 private:
  bool frozen_otherwise() const noexcept { return stepper_ != nullptr && stepper_->frozen(); }
  bool is_frozen_by_others() const noexcept;
  bool take_commands() noexcept;
  bool carry_out(const link::LinkCommand& command) noexcept;

  std::vector<const link::Link*> all_links_;
  std::vector<link::Link*> links_;  ///< that may give commands
  plant::Plant& plant_;
  trace::Recorder& recorder_;
  exec::Stepper* stepper_;
  bool frozen_ = false;      ///< by a command
  std::uint32_t steps_ = 0;  ///< cycles until the plant is frozen; 0: no step is in progress
};

}  // namespace symplant::host
