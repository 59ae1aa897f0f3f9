// What a trainee may operate.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/panel/operate/act_reader.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// Without patterns of an exercise these are what persons operate in a plant: events that no device drives, symbols of
/// the role `operator`, and devices without operations, such as doors and emergency stops. A device
/// with operations is operated by these: a person cannot put it into a state. Used by one thread at a time.
class Allowed {
 public:
  /// `names`, and what `view` refers to, must outlive it. O(plant).
  Allowed(const trace::PlantNames& names, const View& view);

  /// From now on what the patterns match: names of symbols, devices, values, tracks and places. O(plant * patterns).
  void by_patterns(std::span<const std::string> patterns);
  /// From now on what persons operate. O(plant).
  void by_default();

  /// A trainee did a step. What it switches on may be switched off, also if it is no longer allowed: a button that is
  /// held as an exercise ends must not stay on.
  void note(const scenario::Step& step);
  /// Why a trainee may not do an act; empty if the trainee may.
  std::string refusal(const Act& act) const;
  /// Appends the object of the stream: indexes of `symbols`, `devices`, `values` and `locations`. O(plant).
  void put(std::string& json) const;
  /// A different number after each change.
  std::uint64_t version() const { return version_; }

 private:
  std::string not_allowed(std::string_view name) const;
  bool has_operations(std::uint32_t unit) const;
  std::string step_refusal(const scenario::Step& step) const;
  bool switches_off(const scenario::SymbolValue& set) const;

  const trace::PlantNames& names_;
  const View view_;
  std::vector<bool> symbols_;
  std::vector<bool> switched_on_;  ///< symbols, by a trainee
  std::vector<bool> units_;
  std::vector<bool> outputs_;    ///< of values
  std::vector<bool> locations_;  ///< tracks and places
  bool is_by_patterns_ = false;
  std::uint64_t version_ = 0;
};

}  // namespace symplant::panel
