// The naive reference: a second plant, written from docs/model.md alone, as simple as possible. The engine equals it.
//
// It shares with engine and generator only PlantModel, and of that only the symbols, the description and the
// condition trees. It derives states, transitions, actuation and all else itself (difference_from_model() reports
// where the model differs). Every round copies the whole world and steps every unit.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"
#include "support/reference/behaviour.hpp"
#include "support/reference/counters.hpp"
#include "support/reference/world.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::reference {

struct Rules;

/// The net effect of an instant on effective values (after forces), operations and events.
struct InstantRecord {
  Time time = 0;
  /// Symbol and value, in list order: what differs from the end of the previous instant. At the first instant after a
  /// reset: bits that are on, and numbers that differ from their initial values.
  std::vector<std::pair<std::uint32_t, std::uint64_t>> changes;
  std::vector<tables::Finding> findings;                ///< in their order
  std::vector<engine::PartChange> parts;                ///< those by hand first
  std::vector<engine::MalfunctionChange> malfunctions;  ///< those by hand first
  /// Outputs of values that the trace gets at the end of this instant: name and number, in the order of the file.
  std::vector<std::pair<std::string, double>> values;
};

struct UnitView {
  std::uint8_t state;
  std::uint8_t target;
  bool moving;
  bool stopped_midway;
  bool disabled;
  bool frozen;
  Time remaining;  ///< 0 if settled

  friend bool operator==(const UnitView&, const UnitView&) = default;
};

/// Units, symbols, states and requirements are numbered as in the model; members mean the same as in plant::Plant. BOOL
/// values are 0 or 1, numbers are two's complement or the bits of a double.
class Plant {
 public:
  /// `model` must outlive the plant. `behaviours`: by DeviceDescription::behaviour; units with an unknown name
  /// follow the model's rules. The plant is reset.
  explicit Plant(const model::PlantModel& model, std::map<std::string, Behaviour> behaviours = {});
  ~Plant();
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;

  /// The first difference between what the reference derived from names and description and the model, as
  /// text; empty if both agree. Do not run a plant with a difference.
  std::string difference_from_model() const;

  void reset(std::uint64_t seed = 0, Time cycle = 0);
  /// In real time: the link shows the PLC what is on. If plant time did not advance since the last call, this is a
  /// whole cycle in which the PLC sees it.
  void end_cycle();

  void set_operation(std::uint32_t symbol, std::uint64_t value);
  bool set_input(std::uint32_t symbol, std::uint64_t value);
  void force(std::uint32_t symbol, std::uint64_t value);
  void release(std::uint32_t symbol);
  bool is_forced(std::uint32_t symbol) const;
  void set_state(std::uint32_t unit, std::uint8_t state);
  void set_quality(bool well);
  bool put(const tables::PartLocation& to, std::uint32_t kind);
  bool take(const tables::PartLocation& from);
  bool start_malfunction(std::uint32_t number, engine::MalfunctionChange::By by);
  bool stop_malfunction(std::uint32_t number, engine::MalfunctionChange::By by);
  /// Sets a parameter, or the output of an integral, a lag or a ramp, limited. False for other names and kinds, and for
  /// numbers that are not finite.
  bool set_value(const std::string& name, double number);

  /// `ends`: the worlds at the end of each instant at `time` are added there.
  void advance_to(Time time, std::vector<World>* ends = nullptr);
  void advance_before(Time time);
  Time now() const;
  /// `steps`: also those of values and signals, which may be skipped if they would change nothing.
  Time next_due(bool steps = true) const;

  /// Every instant since reset() or clear_instants() that changed a value or raised a finding. Not part of the world.
  const std::vector<InstantRecord>& instants() const;
  void clear_instants();

  std::uint64_t value(std::uint32_t symbol) const;  ///< effective; an operation's as last sampled
  UnitView unit(std::uint32_t unit) const;
  /// An output of a value, by its name: `TANK.level`, `BOOM[2]`. NaN if no output has it.
  double value_output(const std::string& name) const;
  bool is_value_frozen(const std::string& name) const;
  bool is_stuck(std::uint32_t unit) const;
  std::uint32_t malfunction_of_symbol(std::uint32_t symbol) const;  ///< the active one that started last; kNone
  bool disarmed(std::uint32_t symbol) const;                        ///< an operation that is on and not armed
  std::uint64_t state_hash() const;                                 ///< docs/engine.md lists its fields

  const World& save() const;
  void restore(const World& world);

  Counters counters;  ///< since the plant was made

 private:
  const model::PlantModel& model_;
  std::unique_ptr<Rules> rules_;
  World world_;
  Time cycle_ended_ = -1;  ///< the time of the last end_cycle(); -1: none since a reset or restore
  std::vector<InstantRecord> instants_;
};

}  // namespace symplant::reference
