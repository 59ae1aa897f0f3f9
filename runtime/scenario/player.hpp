// Plays a scenario on a plant, in virtual or real time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symplant/exec/stepper.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/scenario/program_control.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::scenario {

/// The outcome of a step.
struct Outcome {
  enum class Kind : std::uint8_t {
    pending,
    done,       ///< it has no expectation and acted
    held,       ///< its expectation held, or its wait was met
    failed,     ///< its expectation did not hold, or its wait was not met in time, in at least one turn
    unreached,  ///< the run ended before it or its last turn; a failure if it has an expectation
  };
  Kind kind = Kind::pending;
  tables::Time time = 0;     ///< of the step; of a wait the time at which it ended; of its last or first failed turn
  std::uint64_t done = 0;    ///< how often it was done, however it ended
  std::uint64_t failed = 0;  ///< how often its expectation failed
};
/// Notes with a lesser `of` are about failed steps.
inline constexpr std::uint32_t kLeastNote = 0xFFFF'FF00;
/// The `of` of a note before that of a failed step: its value is how often the step was done before.
inline constexpr std::uint32_t kTurnNote = 0xFFFF'FFFF;
/// The `of` of a note before that of a failed step: its value is the index of a part in Step::put that has no room,
/// kTakeNote more than an index in Step::take with no part, or kStartNote more than an index in Step::start with a
/// malfunction that cannot start.
inline constexpr std::uint32_t kHandNote = 0xFFFF'FFFD;
inline constexpr std::uint64_t kTakeNote = std::uint64_t{1} << 32;
inline constexpr std::uint64_t kStartNote = std::uint64_t{2} << 32;

/// The `of` of a note about each step that was done, only with Player::note_steps(): its value is the step's index in
/// 32 bits, kStepFailed if its expectation failed, and from kTurnBits on the turn in which it acted (Recorder::turn()).
inline constexpr std::uint32_t kStepNote = 0xFFFF'FFFC;
inline constexpr std::uint64_t kStepFailed = std::uint64_t{1} << 32;
inline constexpr int kTurnBits = 33;

/// The `of` of a note about a refused action of a step or of acts by hand, before the kStepNote or the panel's note
/// about these acts. Its value is that of a kHandNote, and from kRefusedBits on the index of the step within the acts.
inline constexpr std::uint32_t kRefusedNote = 0xFFFF'FFF9;
inline constexpr int kRefusedBits = 34;

/// Plays the steps of a scenario. It acts between instants, and checks at the end of an instant whether a wait is met.
/// It is the plant's observer and forwards everything to a recorder. Only the constructor allocates, so it may advance
/// a plant in real time.
///
/// In virtual time the caller calls advance_to() for each time at which the plant or next() is due. In real time it
/// calls it once per cycle: a step then acts in the first cycle at or after its time, but `plus` still counts from the
/// exact time.
class Player final : public engine::Observer, public exec::Stepper {
 public:
  /// All arguments must outlive the player.
  Player(const Scenario& scenario, plant::Plant& plant, trace::Recorder& recorder);

  /// Advances the plant to `time` and plays the steps that are due until then, including the instants at `time`. For
  /// each failed step it adds a note to the recorder: the step's index, and its time as the value. In a repeat another
  /// note comes before it (kTurnNote).
  void advance_to(tables::Time time) noexcept override;
  /// The time of the next step, or the deadline of the current wait; kNever if the scenario is over.
  tables::Time next() const noexcept;
  bool over() const noexcept override { return position_.at == scenario_.steps.size(); }
  /// Ends the run: marks the remaining steps as unreached.
  void end() noexcept;

  /// Adds a note for each step that is done (kStepNote); with `only`, no notes about failed steps.
  void note_steps(bool only = false) noexcept {
    notes_steps_ = true;
    notes_failures_ = !only;
  }
  /// Sets the interface that restarts programs; it must outlive the player. Null: programs are not restarted.
  void control(ProgramControl* programs) noexcept { programs_ = programs; }
  /// Begins again with the first step at the plant's time, from which the first `plus` counts.
  void begin_again() noexcept;

  /// The position in the scenario, which is saved and restored with a state of the plant.
  struct Position {
    std::size_t at = 0;         ///< index of the next step, or of the current wait
    tables::Time moment = 0;    ///< time of the previous step
    bool waiting = false;       ///< step `at` is a wait, and has begun
    tables::Time deadline = 0;  ///< of the current wait
  };
  struct State {
    Position position;
    std::vector<std::uint32_t> turns;
    std::vector<Outcome> outcomes;
  };
  /// A state with room for save(). For any thread.
  State make_state() const {
    return {{}, std::vector<std::uint32_t>(turns_.size()), std::vector<Outcome>(outcomes_.size())};
  }
  /// Between instants. The state must be made by make_state() of a player of this scenario. O(steps).
  void save(State& state) const noexcept;
  void restore(const State& state) noexcept;

  /// One outcome per step.
  std::span<const Outcome> outcomes() const noexcept { return outcomes_; }

  void instant(const engine::Instant& instant) noexcept override;
  void finding(const tables::Finding& finding) noexcept override { recorder_.finding(finding); }
  void parts_before(tables::Time time, std::span<const engine::PartChange> parts) noexcept override {
    recorder_.parts_before(time, parts);
  }

 private:
  tables::Time time_of(const Step& step) const noexcept;
  bool act(const Step& step) noexcept;
  void make_room(const Step& step) noexcept;
  bool act_by_hand(const Step& step) noexcept;
  bool change_malfunctions(const Step& step) noexcept;
  void refuse(std::uint64_t which) noexcept;
  void advance_plant(tables::Time time) noexcept;
  void decide(Outcome::Kind kind, tables::Time time) noexcept;
  void begin_wait() noexcept;
  void end_met_waits(tables::Time time) noexcept;
  bool wait_until(tables::Time time) noexcept;
  void go_on() noexcept;

  const Scenario& scenario_;
  plant::Plant& plant_;
  trace::Recorder& recorder_;
  ProgramControl* programs_ = nullptr;
  std::vector<Outcome> outcomes_;
  std::vector<std::uint32_t> turns_;  ///< by repeat: turns that are over
  std::vector<std::uint32_t> ends_;   ///< by step and one more: the first repeat that ends at or after it
  /// A note about a refused action by hand. It is added after the instant, whose records show the parts of the step.
  struct LateNote {
    std::uint32_t of;
    std::uint64_t value;
  };
  std::vector<LateNote> late_notes_;
  std::size_t hands_ = 0;  ///< parts put and taken since the last instant
  Position position_;
  bool wait_begins_ = false;  ///< the current wait begins in the instants at the plant's time
  std::uint32_t turn_ = 0;    ///< of the step that acted last
  bool notes_steps_ = false;
  bool notes_failures_ = true;
};

}  // namespace symplant::scenario
