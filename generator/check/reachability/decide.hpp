// Whether a condition can hold at all, and whether it can fail to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "check/reachability/possible.hpp"
#include "model/plant_model.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::check {

enum class Answer : std::uint8_t { no, yes, unknown };

struct Verdict {
  Answer holds = Answer::unknown;  ///< at some time
  Answer fails = Answer::unknown;  ///< at some time

  bool never() const { return holds == Answer::no; }
  bool always() const { return fails == Answer::no; }
  bool known() const { return holds != Answer::unknown && fails != Answer::unknown; }
};

/// Parts of a condition that have things in common are tried in that many combinations of them at most; beyond it the
/// answer may be `unknown`.
inline constexpr std::size_t kMostWorlds = 4096;
/// Conditions of more names and comparisons are not examined: the answer is `unknown`.
inline constexpr std::size_t kMostAtoms = 2000;

/// Considers what atoms have in common: a unit is settled in one state at most and not moving at the same time, a
/// number is not below 3 and above 5. Different units, bits and numbers count as independent of each other, so a `no`
/// is certain, while a `yes` may be too generous. A REAL may be no number, and then no comparison holds. O(condition)
/// where no part shares anything with another, O(kMostWorlds * condition) at worst.
Verdict decide(const condition::Tree& tree, const model::PlantModel& plant, const Possible& possible);

}  // namespace symplant::check
