// Plays a scenario on a plant: acts and looks at its times, whoever paces the plant.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symplant/exec/stepper.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::scenario {

/// What became of a step.
struct Outcome {
  enum class Kind : std::uint8_t {
    pending,
    done,       ///< it only acted
    held,       ///< its expectation held, or its wait was met
    failed,     ///< it did not, or was not in time
    unreached,  ///< the run ended before; a failure where it expects something
  };
  Kind kind = Kind::pending;
  tables::Time time = 0;  ///< its own time; of a wait when it was over
};

/// Between instants it acts, at their ends it looks whether a wait is met: it is the plant's observer, and hands
/// everything on to a recorder. Allocates when it is made and never again, so it may drive a plant in real time.
///
/// In virtual time advance_to() is called for each time at which something is due, by the plant or by next(). In real
/// time it is called once a cycle: a step then acts in the first cycle at or after its time, while `plus` still counts
/// from the time itself.
class Player final : public engine::Observer, public exec::Stepper {
 public:
  /// All must outlive it.
  Player(const Scenario& scenario, plant::Plant& plant, trace::Recorder& recorder);

  /// Brings the plant to `time` and plays what is due until then, the instants of `time` included. For each step that
  /// fails the recorder gets a note: the step's place, and its time as value.
  void advance_to(tables::Time time) noexcept override;
  /// When it next has something to do; kNever when it is over.
  tables::Time next() const noexcept;
  bool over() const noexcept override { return at_ == scenario_.steps.size(); }
  /// The run is over: what is still to come was not reached.
  void end() noexcept;

  /// One a step.
  std::span<const Outcome> outcomes() const noexcept { return outcomes_; }

  void instant(const engine::Instant& instant) noexcept override;
  void finding(const tables::Finding& finding) noexcept override { recorder_.finding(finding); }

 private:
  tables::Time time_of(const Step& step) const noexcept;
  void act(const Step& step) noexcept;
  void set(const SymbolValue& value) noexcept;
  void decide(Outcome::Kind kind, tables::Time time) noexcept;
  bool wait_on() noexcept;

  const Scenario& scenario_;
  plant::Plant& plant_;
  trace::Recorder& recorder_;
  std::vector<Outcome> outcomes_;
  std::size_t at_ = 0;         ///< the step that is next, or is waiting
  tables::Time moment_ = 0;    ///< of the step before
  bool waiting_ = false;       ///< step at_ is a wait, and has begun
  tables::Time deadline_ = 0;  ///< of that
  bool met_ = false;           ///< likewise
  tables::Time met_time_ = 0;
};

}  // namespace symplant::scenario
