// Texts about what was learned, the same in every form.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "learn/learned.hpp"

namespace symplant::learn {

/// A time of a group of devices, for a table.
struct TimeRow {
  const LearnedGroup* group = nullptr;
  std::string of;         ///< `OPEN->CLOSED`; empty: the overrun
  std::string_view kind;  ///< `after`, `takes` or `overrun`
  const LearnedTime* time = nullptr;
  description::Duration model;  ///< that of the first device
};

/// All times, in the order of groups and transitions.
std::vector<TimeRow> time_rows(const Learned& learned);

/// What makes a time odd, in the order of importance.
struct Oddities {
  bool has_groups = false;  ///< more than one group of durations
  std::size_t outliers = 0;
  bool is_wide = false;     ///< the largest is over twice the least, by more than 4 resolutions
  bool is_rare = false;     ///< under 5 samples
  bool is_far_off = false;  ///< from the model's time, by over 20 % and 2 resolutions

  /// The larger, the odder; 0: not at all.
  int rank() const;
  /// "two groups, 3 outliers"; empty if it is not odd.
  std::string text(const TimeRow& row) const;
};
Oddities oddities_of(const TimeRow& row);

/// Whether it is from so few moves that others may differ more.
bool is_of_few(const LearnedTime& time);

/// "0.8 s", "0.65 s to 0.9 s".
std::string duration_words(const description::Duration& duration);

/// "BB_*_CLAMP? (12 devices)".
std::string group_title(const LearnedGroup& group);

/// "412 moves of 12 devices in line2.jsonl, resolution 0.05 s".
std::string provenance(const Learned& learned, const LearnedGroup& group, const LearnedTime& time);

/// "0.8 s to 0.85 s: 60 moves; 1.4 s: 40 moves; with BB_S1_CLAMP2: the first in OPEN, the second in CLOSED (98 of 100
/// moves)". Empty for one group.
std::string groups_text(const Learned& learned, const LearnedTime& time);

/// "4.3 s at 860 s in line2.jsonl", behind the device if the group has several.
std::string outlier_text(const Learned& learned, const LearnedGroup& group, const Sample& sample);

/// "line2.jsonl: 3600 s, resolution 0.05 s".
std::string source_text(const Source& source);

/// "412 moves of 28 devices".
std::string summary(const Learned& learned);

/// A sentence for each reason why many moves of devices are not used.
std::vector<std::string> unused_warnings(const Learned& learned);

/// "L_P_CL 76 of 80 (70 without a cause, 6 turned round)".
std::string unused_text(const Learned& learned, const UnusedMoves& moves);

/// The word in JSON; empty: `few`.
std::string_view reason_name(UnusedReason reason);

/// The file without its folders.
std::string_view file_name(std::string_view path);

/// The transition of a unit as in plant.json: `OPEN->CLOSED`, `OPEN->CLOSED on CLOSE`.
std::string transition_name(const model::PlantModel& plant, std::uint32_t unit, std::uint32_t transition);

}  // namespace symplant::learn
