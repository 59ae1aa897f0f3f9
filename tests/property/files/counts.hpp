// Counts what random files hold and what happens in their runs.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "symplant/tables/finding.hpp"

namespace symplant::property::files {

enum class Seen : std::size_t {
  // In plant.json.
  won,
  shared,
  lost,
  agreeing,
  left_out,
  braces,
  shared_braces,
  made_left_out,
  requirements_for,
  requirements_for_several,
  requirements_left_out,
  disabled_by,
  random_times,
  comments,
  quoted_names,
  stars,
  behaviours,
  lower_case,
  second_lists,
  inverted,
  follows,
  whiles,
  weights,
  overruns,
  sequences,
  // In scenarios, as played.
  at,
  at_past,
  plus,
  waits_met,
  waits_met_at_last,
  waits_failed,
  sets,
  sets_of_inputs,
  sets_behind_expect,
  states,
  forces,
  releases,
  repeats,
  expected_values,
  expected_conditions,
  expectations_held,
  expectations_failed,
  never_reached,
  until,
  until_cut,
  runs_good,
  runs_failed,
  /// The counters of tables::FindingKind begin here, in its order.
  first_finding,
  number_of = first_finding + tables::kFindingKinds - 1,  ///< without `part blocked`: the files have no material yet
};
inline constexpr std::size_t kSeen = static_cast<std::size_t>(Seen::number_of);

/// In the order of Seen.
inline constexpr std::array<std::string_view, kSeen> kSeenNames = {
    "keys from a pattern",
    "keys that several devices have from one pattern",
    "entries beaten by others",
    "equally specific patterns that agree",
    "parts left out where a device lacks them",
    "keys from a pattern with braces",
    "keys with braces that several devices have",
    "parts left out where the plant lacks a name made by braces",
    "requirements `for` a pattern",
    "requirements `for` a pattern of several devices",
    "requirements left out for a device",
    "patterns in `disables`",
    "random times",
    "comments",
    "names in quotes",
    "transitions from `*`",
    "behaviours that are absent",
    "names in lower case",
    "second lists",
    "inverted symbols and patterns",
    "symbols and patterns that follow",
    "transitions with `while`",
    "transitions with a weight",
    "overruns",
    "sequences",
    "steps by `at`",
    "steps whose `at` is past",
    "steps by `plus`",
    "waits met",
    "waits met as their time ends",
    "waits failed",
    "`set`",
    "`set` of events that no device drives",
    "`set` behind an `expect` of its time",
    "`state`",
    "`force`",
    "`release`",
    "`repeat`",
    "values expected",
    "conditions expected",
    "expectations held",
    "expectations failed",
    "expectations and waits never reached",
    "runs with `--until`",
    "scenarios cut by `--until`",
    "runs that exit with 0",
    "runs that exit with 1",
    "found: conflicting operations",
    "found: stopped under another command",
    "found: command to a disabled unit",
    "found: command without effect",
    "found: overrun",
    "found: lost command",
    "found: started on enabling",
    "found: event too short",
    "found: instantaneous loop",
    "found: requirement violated",
};

struct Counts {
  std::array<long, kSeen> counts{};

  long& operator[](Seen what) { return counts[static_cast<std::size_t>(what)]; }
  long& of(tables::FindingKind kind) {
    return counts[static_cast<std::size_t>(Seen::first_finding) + static_cast<std::size_t>(kind)];
  }
  Counts& operator+=(const Counts& other) {
    for (std::size_t i = 0; i < kSeen; ++i) counts[i] += other.counts[i];
    return *this;
  }
};

}  // namespace symplant::property::files
