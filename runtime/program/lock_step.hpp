// PLC programs that run in lock step with a plant.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symplant/exec/stepper.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/program/crash.hpp"
#include "symplant/program/instance.hpp"
#include "symplant/program/library.hpp"
#include "symplant/scenario/program_control.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::program {

/// Why the run must end: a program failed.
struct Failure {
  std::string_view program;
  std::int64_t scan;  ///< -1: at its start
  tables::Time time;
  int code;  ///< what the scan returned
};

/// "program `cell` failed with 7 in scan 812 (8.12 s)".
std::string failure_words(const Failure& failure);

/// Runs programs with a plant, in plant time. Scan k of a program takes place at k * period, as the last thing at that
/// time: it reads the events as they are after all instants. What it writes is sampled after its delay, in the first
/// instant of that time. Programs that are due at one time all read before one writes, so that their order does not
/// matter (the static schedule of Henzinger et al., Giotto).
///
/// All calls of the programs are made by the thread that advances it, from the first advance_to() to end(). One thread
/// at a time may use it.
class LockStep final : public exec::Stepper, public scenario::ProgramControl {
 public:
  /// `observer` may be null. It and the plant must outlive this.
  explicit LockStep(plant::Plant& plant, engine::Observer* observer = nullptr);
  ~LockStep() { end(); }

  /// Adds a program, which must outlive this; only before the first advance_to(). Returns why that is not possible, a
  /// line for each reason; empty if it was added. O((symbols + variables) log symbols).
  std::string add(const symplant_program& program, const Options& options = {});
  /// Advances the plant by another stepper, such as a scenario. Null: by the plant itself.
  void drive(exec::Stepper* stepper) noexcept { stepper_ = stepper; }
  /// To be called if links read the plant's changed events too, in a real-time cycle that forgets them. Otherwise
  /// advance_to() forgets them.
  void share_events() noexcept { shares_events_ = true; }

  /// Runs the plant and the scans up to `time`, including both at `time`. After a failure it does nothing. O(scans and
  /// changes).
  void advance_to(tables::Time time) noexcept override;
  bool frozen() const noexcept override { return stepper_ != nullptr && stepper_->frozen(); }
  void hold() noexcept override;
  bool over() const noexcept override { return stepper_ != nullptr && stepper_->over(); }
  bool failed() const noexcept override { return failure_.has_value(); }
  /// The time of the next scan, or of the next sample of operations.
  tables::Time next_due() const noexcept;
  /// The failure that ended the programs; nothing if no program has failed.
  const std::optional<Failure>& failure() const noexcept { return failure_; }
  /// Ends all programs; in the thread of advance_to().
  void end() noexcept;

  bool restart(std::uint32_t controller) noexcept override;
  void reset() noexcept override;

 private:
  struct Running {
    std::unique_ptr<Binding> binding;
    std::unique_ptr<Instance> instance;
    tables::Time next = 0;  ///< time of the next scan
    bool lost = false;      ///< its controller is
  };

  void begin() noexcept;
  void advance_plant(tables::Time time, bool is_end) noexcept;
  void write_due(tables::Time time) noexcept;
  void take_events() noexcept;
  void scan_due(tables::Time time) noexcept;
  bool note_losses() noexcept;
  void fail(const Instance& instance, std::int64_t scan, int code) noexcept;

  plant::Plant& plant_;
  engine::Observer* observer_;
  trace::PlantNames names_;
  exec::Stepper* stepper_ = nullptr;
  bool may_lose_ = false;  ///< a malfunction of the plant loses a controller
  bool shares_events_ = false;
  bool begun_ = false;
  bool any_lost_ = false;
  std::vector<Running> programs_;
  std::optional<CrashReport> crashes_;
  std::optional<Failure> failure_;
};

}  // namespace symplant::program
