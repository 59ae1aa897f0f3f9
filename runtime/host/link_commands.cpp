// Carries out the commands that clients of links give to a run.
#include "symplant/host/link_commands.hpp"

#include <algorithm>

#include "symplant/host/run_acts.hpp"

namespace symplant::host {
namespace {

constexpr std::size_t kCommandsOfCycle = 16;  ///< of each link; the next cycle takes the others
constexpr std::size_t kNotesOfCommand = 2;

}  // namespace

LinkCommands::LinkCommands(const Links& links, plant::Plant& plant, trace::Recorder& recorder, exec::Stepper* stepper)
    : plant_(plant), recorder_(recorder), stepper_(stepper) {
  for (const OpenLink& open : links) {
    all_links_.push_back(open.link.get());
    if (open.link->has_commands()) links_.push_back(open.link.get());
  }
}

/// Returns whether it acted on the plant.
bool LinkCommands::carry_out(const link::LinkCommand& command) noexcept {
  using Kind = link::LinkCommand::Kind;
  using By = engine::MalfunctionChange::By;
  switch (command.kind) {
    case Kind::start_malfunction:
    case Kind::end_malfunction: {
      const bool starts = command.kind == Kind::start_malfunction;
      recorder_.begin_act(plant_.now());
      recorder_.act(plant_.now(), trace::kActNote, run_act(command.of, starts, true));
      starts ? plant_.start_malfunction(command.of, By::hand) : plant_.stop_malfunction(command.of, By::hand);
      return true;
    }
    case Kind::freeze:
      frozen_ = true;
      steps_ = 0;
      return false;
    case Kind::run:
      frozen_ = false;
      steps_ = 0;
      return false;
    case Kind::step:
      frozen_ = false;
      steps_ = command.of;
      return false;
  }
  return false;
}

/// Something other than commands.
bool LinkCommands::is_frozen_by_others() const noexcept {
  return frozen_otherwise() || std::any_of(all_links_.begin(), all_links_.end(),
                                           [](const link::Link* link) { return link->freezes_plant(); });
}

bool LinkCommands::take_commands() noexcept {
  const bool frozen = is_frozen_by_others();
  bool acted = false;
  for (link::Link* const link : links_) {
    for (std::size_t i = 0; i < kCommandsOfCycle && recorder_.has_room(kNotesOfCommand); ++i) {
      const auto command = link->take_command(frozen);
      if (!command) break;
      if (carry_out(*command)) acted = true;
    }
  }
  return acted;
}

void LinkCommands::advance_to(tables::Time time) noexcept {
  take_commands();
  stepper_ != nullptr ? stepper_->advance_to(time) : plant_.advance_to(time, &recorder_);
  if (steps_ != 0 && --steps_ == 0) frozen_ = true;
}

void LinkCommands::hold() noexcept {
  const bool acted = take_commands();
  if (stepper_ != nullptr) stepper_->hold();
  if (!acted) return;
  stepper_ != nullptr ? stepper_->advance_within(plant_.now()) : plant_.advance_to(plant_.now(), &recorder_);
}

}  // namespace symplant::host
