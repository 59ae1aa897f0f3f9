// What a trainer sees of the trainees: what each did, and how fast they reacted to malfunctions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "symplant/panel/role.hpp"
#include "symplant/panel/training/malfunction_runs.hpp"
#include "symplant/panel/training/trainees.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The trainees, and the malfunctions to which they react. A reaction time is the plant time from the first effect of a
/// malfunction to the trainee's first act on the plant after it, until the malfunction ends. Used by one thread at a
/// time. Takes at most about 3 MiB.
class Training {
 public:
  static constexpr std::size_t kMostShown = 50;  ///< malfunctions in the stream

  /// Both must outlive it.
  Training(const trace::PlantNames& names, const trace::History& history) : names_(names), runs_(names, history) {}

  /// As MalfunctionRuns::apply().
  void apply(const trace::Record& record) { runs_.apply(record); }
  /// As MalfunctionRuns::set_back().
  void set_back(tables::Time after);

  /// Whether a sender is in the table: a trainee with a name.
  static bool is_listed(const Sender& sender) { return sender.role == Role::trainee && !sender.name.empty(); }
  /// A trainee joins at plant time `now`. False if it is one more than Trainees::kMost.
  bool seen(const Sender& sender, tables::Time now);
  /// The sender acted on the plant.
  void acted(const Sender& sender, tables::Time time);
  /// A request of the sender was answered with this status: 403 and 422 are refusals.
  void answered(const Sender& sender, int status, tables::Time now);

  /// Appends the object `training` (docs/panel-interface.md) with the last `most` malfunctions.
  void put(std::string& json, std::size_t most) const;
  /// A line for each trainee, as comma-separated values.
  std::string trainees_csv() const;
  /// A line for each malfunction and each trainee, as comma-separated values.
  std::string reactions_csv() const;
  /// Grows with each change.
  std::uint64_t version() const { return runs_.version() + trainees_.version(); }

 private:
  /// Of the reaction times of a trainee, in ns.
  struct Summary {
    std::uint64_t count = 0;
    tables::Time least = 0;
    tables::Time greatest = 0;
    double sum = 0;

    void add(tables::Time time);
    tables::Time mean() const { return static_cast<tables::Time>(sum / static_cast<double>(count)); }
  };
  Summary summary_of(std::uint32_t trainee) const;
  void put_trainee(std::string& json, std::uint32_t trainee) const;
  void put_run(std::string& json, const MalfunctionRun& run) const;

  const trace::PlantNames& names_;
  MalfunctionRuns runs_;
  Trainees trainees_;
};

}  // namespace symplant::panel
