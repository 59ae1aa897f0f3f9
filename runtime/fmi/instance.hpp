// One plant in a co-simulation: variables are set and read, steps advance it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/fmi/shown_events.hpp"
#include "symplant/fmi/variables.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::fmi {

/// The plant of an FMU. All of it must outlive its instances, which may be in different threads.
struct PlantModel {
  const tables::PlantTables& tables;
  std::span<const engine::Behaviour> behaviours;
  const Variables& variables;
};

/// Why something was refused; empty: it was done.
using Fault = std::string;

/// An instance at a communication point.
struct InstanceState {
  std::vector<std::byte> plant;        ///< Plant::save()
  std::vector<std::uint64_t> numbers;  ///< all other numbers of the instance
};

/// An instance of the plant. It is not thread-safe; instances share nothing that changes.
///
/// What is set takes effect together, at the beginning of the next step: in an instant at the time at which the last
/// step ended. A step runs all further instants up to its end, those at its end included. Plant time 0 is the start
/// time of the experiment.
class Instance {
 public:
  /// In the initial state. O(plant).
  explicit Instance(const PlantModel& model);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  const plant::Plant& plant() const noexcept { return plant_; }

  // Variables are given by their index in Variables::all(). A boolean is 0 or 1. All O(1), except that setting costs
  // its effects in the plant.

  double real(std::uint32_t variable) const;           ///< of a real variable
  std::int32_t integer(std::uint32_t variable) const;  ///< of all others
  /// Refuses a variable that cannot be set, a number outside of the symbol's type or the parameter's limits, the seed
  /// after begin(), and a malfunction that is one too many.
  Fault set_real(std::uint32_t variable, double number);
  Fault set_integer(std::uint32_t variable, std::int32_t number);

  /// The time of the experiment at which plant time is 0, and its end, which may be infinite; in s. To be called before
  /// begin().
  Fault begin_at(double start, double stop);
  /// Ends the settings before the first step: the plant begins with the seed that was set. O(plant).
  void begin();
  /// Advances from `time`, at which the last step ended, by `duration` >= 0, both in s. O(changes).
  Fault step(double time, double duration);
  /// The time at which the last step ended, in s.
  double time() const noexcept;
  /// The events of which the last step held a pulse to its end, as rows in PlantTables::symbols. O(those).
  std::vector<std::uint32_t> held_events() const;

  /// As after construction.
  void reset();
  InstanceState save() const;
  /// False, and nothing changes, if the state does not fit the plant. The bytes must be unaltered. O(plant).
  bool restore(const InstanceState& state);

 private:
  struct Observer final : engine::Observer {
    explicit Observer(const plant::Plant& observed) : plant(observed) {}
    void instant(const engine::Instant& instant) noexcept override { shown.see(plant, instant); }
    void finding(const tables::Finding& finding) noexcept override {
      if (finding.kind == tables::FindingKind::requirement_violated) ++violations;
    }

    const plant::Plant& plant;
    ShownEvents shown;
    std::uint64_t violations = 0;
  };

  void restart();
  Fault set(std::uint32_t variable, std::uint64_t value);
  Fault set_symbol(std::uint32_t variable, double number);
  Fault apply(const Variable& variable, std::uint64_t value);
  void write_operation(std::uint32_t symbol, std::uint64_t value) noexcept;
  std::uint64_t event(std::uint32_t symbol) const noexcept;
  tables::Time end_of_step(double time, double duration) const noexcept;
  std::uint64_t sampled(std::uint32_t symbol) const noexcept;
  std::uint64_t initial(const Variable& variable) const noexcept;
  std::uint64_t value(std::uint32_t variable) const noexcept;
  const Variable& at(std::uint32_t variable) const noexcept { return model_.variables.all()[variable]; }

  PlantModel model_;
  plant::OwnedPlant plant_;
  Observer observer_;
  std::vector<std::uint32_t> symbol_of_event_;  ///< by bit of a BOOL event
  std::vector<std::uint64_t> set_;              ///< by settable variable: what was set last
  std::vector<std::uint64_t> early_;            ///< bits by settable variable: set before begin()
  std::vector<bool> leads_;                     ///< by symbol: others are on its address
  double start_ = 0;
  double stop_ = std::numeric_limits<double>::infinity();
  bool begun_ = false;
};

}  // namespace symplant::fmi
