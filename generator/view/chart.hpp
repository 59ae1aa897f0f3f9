// A device's state chart in words: what all drawings of it show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "view/cross_references.hpp"

namespace symplant::view {

/// ChartEdge::from of an arrow that stands for one from every other state.
inline constexpr std::uint32_t kEveryOther = 0xFFFF'FFFF;

struct ChartState {
  std::string name;
  std::string symbols;  ///< `O_P1, I_P1`; empty where none names it
};

/// All transitions from one state to another. Without `automatic` it has a commanded one among them.
struct ChartEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool automatic = false;
  std::vector<std::string> label;  ///< lines
};

struct Chart {
  std::vector<ChartState> states;
  std::vector<ChartEdge> edges;  ///< by target, then source
};

/// How a condition stands in a label.
enum class Conditions : std::uint8_t {
  in_words,   ///< a short one as it is, a long one as its number: `[c1]`
  by_number,  ///< always as its number, so that devices of one structure have one chart
};

/// The states and arrows of a unit. Where at least four states are and each of the others has the same way to a state,
/// one arrow stands for all of these. O(transitions).
Chart chart_of(const model::Unit& unit, const model::PlantModel& plant, Conditions conditions = Conditions::in_words);

/// Everything of a unit that its chart has no room for, a line each: what it is, its signals with addresses and rows,
/// conditions by number, outputs, disables, behaviour, requirements that name it.
std::vector<std::string> facts_of(std::uint32_t unit, const model::PlantModel& plant,
                                  const CrossReferences& references);

}  // namespace symplant::view
