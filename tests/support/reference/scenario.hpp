// A scenario on the naive reference, as docs/plant-description.md defines it: step by step, instant by instant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/reference/reference.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::reference {

/// The result of a step of a scenario.
struct Verdict {
  std::size_t step;
  bool held;
  bool reached;  ///< false: `until` came first
  Time time;     ///< when it was checked, met or given up
  bool expects;  ///< false: it only acts
};

/// Symbols, units and states are numbered as in the model.
struct ScenarioStep {
  enum class When : std::uint8_t { at, plus, wait };
  When when = When::plus;
  std::optional<Time> time;               ///< of `at` and `plus`; of `wait` its `within`
  const condition::Tree* wait = nullptr;  ///< of `wait`
  std::vector<std::pair<std::uint32_t, std::uint64_t>> set;
  std::vector<std::pair<std::string, double>> values;  ///< with `set`
  std::vector<std::pair<std::uint32_t, std::uint8_t>> states;
  std::vector<std::pair<tables::PartLocation, std::uint32_t>> put;  ///< with the kind
  std::vector<tables::PartLocation> take;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> force;
  std::vector<std::uint32_t> release;
  std::vector<std::uint32_t> stop;   ///< malfunctions
  std::vector<std::uint32_t> start;  ///< malfunctions
  bool starts_ordinary = false;
  bool expects = false;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> expect;
  const condition::Tree* expect_condition = nullptr;

  bool is_expectation() const { return expects || when == When::wait; }
  /// Whether it has a verdict.
  bool is_checked() const { return is_expectation() || !put.empty() || !take.empty() || starts_ordinary; }
};

/// Plays the given steps, one after the other, on a plant that has just been reset.
class ScenarioPlayer {
 public:
  /// Both must outlive the player. It stops after `most_instants`: see exhausted().
  ScenarioPlayer(const model::PlantModel& model, Plant& plant, std::optional<Time> until, long most_instants)
      : model_(&model), plant_(&plant), until_(until), left_(most_instants) {}

  void play(const ScenarioStep& step);
  /// After the last step.
  void end();

  /// The plant has more instants than allowed. Its results are then undefined.
  bool exhausted() const { return left_ <= 0; }
  /// `until` has come; no further step acts.
  bool cut() const { return cut_; }
  const std::vector<Verdict>& verdicts() const { return verdicts_; }
  /// The last step is a wait that was met, and a further instant of the same time came after.
  bool met_before_a_further_instant() const { return ends_.size() > 1; }

 private:
  bool go_to(Time time);
  /// False if a part had no room, or there was none to take, or too many malfunctions are active.
  bool act(const ScenarioStep& step);
  void wait(const ScenarioStep& step);
  bool is_met(const condition::Tree& condition);
  bool expected(const ScenarioStep& step) const;
  void instant();

  const model::PlantModel* model_;
  Plant* plant_;
  std::optional<Time> until_;
  long left_;
  bool cut_ = false;
  std::size_t number_ = 0;
  std::vector<Verdict> verdicts_;
  std::vector<World> ends_;  ///< of the instants at the present time that the next wait looks at
};

}  // namespace symplant::reference
