// Exercises for trainees: scenarios with a title, whose steps give points.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "symplant/panel/role.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// A scenario that can be played from the panel.
struct ExerciseFile {
  std::string name;  ///< of the file, without folder and ending
  std::shared_ptr<const scenario::Scenario> scenario;
};

/// The exercise that is played, its progress and its points so far. Used by one thread at a time.
class Exercise {
 public:
  /// `names` must outlive it.
  Exercise(const ExerciseFile& file, const trace::PlantNames& names);

  void begin(tables::Time time);
  /// A step was done.
  void step_done(std::size_t step, bool failed, tables::Time time);
  void requirement_violated(std::uint32_t requirement, tables::Time time);
  /// Its last step was done: points for the time.
  void over(tables::Time time);
  /// Ends it by hand, unless it is over: what it still waits for is not reached.
  void end(tables::Time time);

  enum class State : std::uint8_t { pending, done, failed };
  struct Point {
    tables::Time time;
    std::int64_t points;
    std::string text;
  };
  /// The progress of the exercise and its points so far.
  struct Progress {
    std::vector<State> states;         ///< by step
    std::vector<tables::Time> times;   ///< by step: when it was done last
    std::vector<std::uint64_t> turns;  ///< by step: how often it was done
    std::vector<Point> points;
    std::size_t next = 0;  ///< the step that is done next
    std::int64_t score = 0;
    tables::Time since = 0;
    tables::Time took = -1;  ///< -1: it is not over
  };
  const Progress& progress() const { return progress_; }
  /// Restores an earlier progress of this exercise.
  void go_back_to(const Progress& progress);

  const std::string& name() const { return file_.name; }
  const scenario::Scenario& scenario() const { return *file_.scenario; }
  bool is_over() const { return progress_.took >= 0; }
  /// Appends the exercise as an object (docs/panel-interface.md), as a role sees it.
  void put(std::string& json, Role role) const;
  /// A test case for each expectation, for what was refused or not reached of the other steps, and for the score.
  void add_cases(std::vector<trace::TestCase>& cases) const;
  /// Grows with each change.
  std::uint64_t version() const { return version_; }

 private:
  /// Why the test case of a step failed; empty if it did not fail.
  const char* failure_of(std::size_t step) const;
  void put_step(std::string& json, std::size_t step, Role role) const;
  void put_score(std::string& json) const;
  void add_points(tables::Time time, std::int64_t points, std::string text);
  std::int64_t most() const;

  ExerciseFile file_;
  const trace::PlantNames& names_;
  Progress progress_;
  std::uint64_t version_ = 1;
};

/// Appends the array of all exercises for the description of the plant.
void put_exercises(std::string& json, const std::vector<ExerciseFile>& files);

}  // namespace symplant::panel
