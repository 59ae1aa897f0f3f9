// What was done in a session, so that it can be played again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/operate/snapshots.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// Something that was done, by hand or by a scenario.
struct Deed {
  tables::Time time = 0;
  std::uint64_t turn = 0;   ///< equal for what took effect in one instant
  bool further = false;     ///< earlier deeds at this time took effect in an earlier instant
  std::string by;           ///< `hand`, `trainee` or `scenario`
  std::string json;         ///< an object: the act
  std::string actions;      ///< its members if it is a step of a scenario; else empty
  std::string name = {};    ///< of the trainee; empty: it gave none
  std::uint64_t shown = 0;  ///< of a trainee: the number among those of trainees, from 0
};

/// Deed::by of an act by a client of this role.
constexpr std::string_view name_of_hand(Role role) { return sees_all(role) ? "hand" : role_name(Role::trainee); }

/// The acts since the start of a run. Used by one thread at a time.
class Session {
 public:
  static constexpr std::size_t kMostSteps = 100'000;                    ///< of the scenario; more are not kept
  static constexpr std::size_t kMostStepBytes = std::size_t{32} << 20;  ///< of their texts

  Session(const trace::PlantNames& names, std::uint64_t seed) : names_(names), seed_(seed) {}

  void add(Deed deed);
  /// The plant begins again at time 0, or at a state: the scenario begins again.
  void begin_again(std::shared_ptr<const KeptState> from);

  /// The state with which the scenario begins; null: the initial one.
  const std::shared_ptr<const KeptState>& from() const { return from_; }
  /// A scenario that does the same, until `end`. `restore`: the name of the file of from(). O(acts).
  std::string scenario(std::string_view restore, tables::Time end) const;
  /// False if there were more than kMostSteps steps or kMostStepBytes, so that scenario() is not complete.
  bool is_complete() const { return is_complete_; }

  /// Appends the acts from number `from` on, for the stream. Only a trainer sees those that no trainee did;
  /// the others are numbered among themselves.
  void put(std::string& json, std::uint64_t from, Role role) const;
  /// The number of acts so far.
  std::uint64_t count() const { return first_ + deeds_.size(); }

 private:
  const trace::PlantNames& names_;
  std::uint64_t seed_;
  std::deque<Deed> deeds_;   ///< the latest, of any kind
  std::uint64_t first_ = 0;  ///< the number of the first of them
  std::uint64_t shown_ = 0;  ///< how many trainees did
  std::size_t deed_bytes_ = 0;
  std::vector<Deed> steps_;  ///< since the plant began again
  std::size_t step_bytes_ = 0;
  bool is_complete_ = true;
  std::shared_ptr<const KeptState> from_;
};

}  // namespace symplant::panel
