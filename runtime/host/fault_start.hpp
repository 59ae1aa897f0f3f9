// Starts a malfunction at a time of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

#include "symplant/exec/stepper.hpp"
#include "symplant/host/run_acts.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::host {

/// The number of a malfunction by its name; nothing, with a message on `err`, if the plant does not have it. O(plant).
std::optional<std::uint32_t> fault_of(const std::string& name, const trace::PlantNames& names, std::ostream& err);

/// A stepper that starts a malfunction, and otherwise passes everything on: to another stepper, or to the plant. The
/// start takes effect before the first round of the instant at its time and before a scenario's steps of that time.
/// After a reset of the plant it starts again. Real-time safe.
class FaultStart final : public exec::Stepper {
 public:
  /// `number` as tables::MalfunctionNumbers has it. The references must outlive this.
  FaultStart(std::uint32_t number, tables::Time at, plant::Plant& plant, trace::Recorder& recorder)
      : number_(number), at_(at), plant_(plant), recorder_(recorder) {}

  /// Advances the plant by another stepper; null: by itself.
  void drive(exec::Stepper* stepper) noexcept { stepper_ = stepper; }
  /// The time of the start; kNever if it has started.
  tables::Time next() const noexcept { return started_ ? tables::kNever : at_; }

  void advance_to(tables::Time time) noexcept override {
    start_if_due(time);
    stepper_ != nullptr ? stepper_->advance_to(time) : plant_.advance_to(time, &recorder_);
    last_ = plant_.now();
  }
  void advance_within(tables::Time time) noexcept override {
    start_if_due(time);
    stepper_ != nullptr ? stepper_->advance_within(time) : plant_.advance_to(time, &recorder_);
    last_ = plant_.now();
  }
  bool frozen() const noexcept override { return stepper_ != nullptr && stepper_->frozen(); }
  void hold() noexcept override {
    if (stepper_ != nullptr) stepper_->hold();
  }
  bool over() const noexcept override { return stepper_ != nullptr && stepper_->over(); }
  bool failed() const noexcept override { return stepper_ != nullptr && stepper_->failed(); }

 private:
  void start_if_due(tables::Time time) noexcept {
    if (plant_.now() < last_) started_ = false;
    if (started_ || time < at_) return;
    if (stepper_ != nullptr && plant_.next_due() < at_) stepper_->advance_within(at_ - 1);
    plant_.advance_before(at_, &recorder_);
    recorder_.begin_act(plant_.now());
    recorder_.act(plant_.now(), trace::kActNote, run_act(number_, true, false));
    plant_.start_malfunction(number_, engine::MalfunctionChange::By::scenario);
    started_ = true;
  }

  const std::uint32_t number_;
  const tables::Time at_;
  plant::Plant& plant_;
  trace::Recorder& recorder_;
  exec::Stepper* stepper_ = nullptr;
  bool started_ = false;
  tables::Time last_ = 0;  ///< the plant's time after the last call
};

}  // namespace symplant::host
