// Exercises for trainees: scenarios with a title, whose steps give points.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

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

/// The exercise that is played, and what it gave so far. Used by one thread at a time.
class Exercise {
 public:
  /// `names` must outlive it.
  Exercise(const ExerciseFile& file, const trace::PlantNames& names);

  void begin(tables::Time time);
  /// A step was done.
  void step_done(std::size_t step, bool failed, tables::Time time);
  void requirement_violated(std::uint32_t requirement, tables::Time time);
  void over(tables::Time time);

  const std::string& name() const { return file_.name; }
  const scenario::Scenario& scenario() const { return *file_.scenario; }
  bool is_over() const { return took_ >= 0; }
  std::int64_t score() const { return score_; }
  /// Appends the object of the interface.
  void put(std::string& json) const;
  /// A test case for each step with an expectation, and one for the score.
  void add_cases(std::vector<trace::TestCase>& cases) const;
  /// Grows with each change.
  std::uint64_t version() const { return version_; }

 private:
  enum class State : std::uint8_t { pending, done, failed };
  struct Point {
    tables::Time time;
    std::int64_t points;
    std::string text;
  };

  void add_points(tables::Time time, std::int64_t points, std::string text);
  std::int64_t most() const;

  ExerciseFile file_;
  const trace::PlantNames& names_;
  std::vector<State> states_;
  std::vector<tables::Time> times_;
  std::vector<Point> points_;
  std::size_t next_ = 0;
  std::int64_t score_ = 0;
  tables::Time since_ = 0;
  tables::Time took_ = -1;  ///< -1: it is not over
  std::uint64_t version_ = 1;
};

/// Appends the array of all exercises for the description of the plant.
void put_exercises(std::string& json, const std::vector<ExerciseFile>& files);

}  // namespace symplant::panel
