// How many I/O symbols of a plant are paired and accounted for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::score {

/// What a symbol counts as. Those from `no_rule` on are not accounted for.
enum class Verdict : std::uint8_t {
  not_counted,  ///< not BOOL, or ignored
  paired,       ///< an operation that moves an event, or an event that an operation moves
  constant,
  operator_panel,
  data,
  parts,           ///< a sensor of parts
  follow,          ///< an input that follows a condition
  condition,       ///< an operation that moves no event, but parts or an input that follows
  no_rule,         ///< its name or comment matches no rule
  no_direction,    ///< neither address nor name says a direction
  no_operation,    ///< an event that nothing moves
  no_event,        ///< an operation that moves no event
  task_taken,      ///< another symbol has its task
  unit_too_large,  ///< its device has too many symbols
  named_internal,  ///< its name says that it is neither operation nor event
  role_none,       ///< its rule has the role `none`
};
inline constexpr std::size_t kVerdicts = 16;

constexpr bool is_left_over(Verdict verdict) { return verdict >= Verdict::no_rule; }
/// The key in JSON: `no_rule`.
std::string_view verdict_key(Verdict verdict);

/// Symbols by verdict.
class Counts {
 public:
  void add(Verdict verdict) { ++by_verdict_[static_cast<std::size_t>(verdict)]; }

  std::size_t of(Verdict verdict) const { return by_verdict_[static_cast<std::size_t>(verdict)]; }
  std::size_t paired() const { return of(Verdict::paired); }
  std::size_t accounted() const { return sum(Verdict::paired, static_cast<std::size_t>(Verdict::no_rule)); }
  std::size_t left_over() const { return sum(Verdict::no_rule, kVerdicts); }  ///< not accounted for
  std::size_t counted() const { return accounted() + left_over(); }

 private:
  /// Of the verdicts from `first` to before `end`.
  std::size_t sum(Verdict first, std::size_t end) const;

  std::array<std::uint32_t, kVerdicts> by_verdict_{};
};

struct Score {
  Counts total;
  std::vector<Verdict> verdicts;  ///< one for each symbol of the plant
  std::size_t named = 0;          ///< symbols whose name follows the built-in rule, or that a custom one pairs
};

/// Under a custom naming rule by its pairing, under the built-in one by paired_by_task(). O(symbols).
Score score_of(const model::PlantModel& plant);

}  // namespace symplant::score
