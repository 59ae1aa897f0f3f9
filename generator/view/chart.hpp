// A device's state chart in words: what all drawings of it show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "view/cross_references.hpp"

namespace symplant::view {

/// ChartEdge::from of an arrow that represents transitions from every other state.
inline constexpr std::uint32_t kEveryOther = 0xFFFF'FFFF;

struct ChartState {
  std::string name;
  std::string symbols;  ///< `O_P1, I_P1`; empty if no symbol names it
};

/// All transitions from one state to another.
struct ChartEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool automatic = false;          ///< all of them are automatic
  std::vector<std::string> label;  ///< lines
};

struct Chart {
  std::vector<ChartState> states;
  std::vector<ChartEdge> edges;  ///< by target, then source
};

/// How a label shows a condition.
enum class Conditions : std::uint8_t {
  in_words,   ///< a short one as its text, a long one as its number: `[c1]`
  by_number,  ///< always as its number, so that devices of equal structure share a chart
};

/// The states and arrows of a unit. In a unit with at least four states, equal transitions from all other states to one
/// state become one arrow. O(transitions).
Chart chart_of(const model::Unit& unit, const model::PlantModel& plant, Conditions conditions = Conditions::in_words);

/// The facts about a unit that its chart does not show, a line each: actuation and initial state, signals with
/// addresses and rows, conditions by number, outputs, disables, behavior, requirements that name it.
std::vector<std::string> facts_of(std::uint32_t unit, const model::PlantModel& plant,
                                  const CrossReferences& references);

}  // namespace symplant::view
