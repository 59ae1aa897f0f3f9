// What active malfunctions and forces do to units, symbols and links, in words.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// The active malfunctions in the order in which they started.
using ActiveMalfunctions = std::span<const History::Malfunction>;

/// "malfunction `jam`".
std::string malfunction_words(std::uint32_t malfunction, const PlantNames& names);

/// "malfunction `jam`, malfunction `rust`": those that disable a unit; empty without any. This function and the
/// next are O(active malfunctions * log of the units of one).
std::string disabling_malfunctions(std::uint32_t unit, const PlantNames& names, ActiveMalfunctions active);

/// Whether another device is in a state that disables the unit. O(disables).
bool is_disabled_by_device(std::uint32_t unit, const PlantNames& names, const History& history);

/// As disabling_malfunctions(), those that slow a unit.
std::string slowing_malfunctions(std::uint32_t unit, const PlantNames& names, ActiveMalfunctions active);

/// Those that stop, or slow, the drives of a track.
std::string stopping_malfunctions(std::uint32_t track, const PlantNames& names, ActiveMalfunctions active);
std::string braking_malfunctions(std::uint32_t track, const PlantNames& names, ActiveMalfunctions active);

/// "malfunction `gust`": the one that started last of those that hold a parameter; empty if it is free. O(active
/// malfunctions * parameters of one).
std::string holding_malfunction(std::uint32_t value, const PlantNames& names, ActiveMalfunctions active);

/// "malfunction `wire`": the one that started last of those that override a symbol; empty without one.
/// O(active malfunctions * symbols of one).
std::string overriding_malfunction(std::uint32_t symbol, const PlantNames& names, ActiveMalfunctions active);

/// "malfunction `cable`": those that cut the link of a controller; empty without any. O(active malfunctions).
std::string cutting_malfunctions(std::uint32_t controller, const PlantNames& names, ActiveMalfunctions active);

/// Collects the malfunctions and forces that explain a finding, so that the program of the PLC need not be its cause.
class Influences {
 public:
  Influences(const PlantNames& names, const History& history) : names_(names), history_(history) {}

  Influences& holding(std::uint32_t unit);  ///< malfunctions that disable a unit
  Influences& slowing(std::uint32_t unit);  ///< malfunctions that slow a unit
  Influences& forcing(std::uint32_t symbol);
  Influences& forcing_symbols_of(std::uint32_t unit);
  Influences& cutting(std::uint32_t controller);  ///< malfunctions that cut its link

  bool empty() const { return found_.empty(); }
  /// "malfunction `jam` holds L_P_AGV, malfunction `wire` forces event P1 (X0001), event P2 (X0002) is forced since 3
  /// s"; of more than four the first ones and how many more there are.
  std::string words() const;
  /// The end of a finding: ": check how the program reacts" after the words, else "check " and the usual advice.
  std::string advice(std::string_view usual) const;

 private:
  const PlantNames& names_;
  const History& history_;
  std::vector<std::string> found_;
};

}  // namespace symplant::trace
