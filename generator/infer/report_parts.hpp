// The parts of a report, each computed from an applied naming rule.
#pragma once

#include <span>

#include "infer/report_data.hpp"
#include "infer/report_texts.hpp"

namespace symplant::infer {

/// What the parts are computed from.
struct ReportInput {
  const name::CompiledNaming& naming;
  std::span<const Sample> samples;
  const Applied& applied;
  ReportTexts& texts;

  /// Whether nothing accounts for a symbol, and it is not set aside.
  bool is_left_over(std::uint32_t sample) const;
  bool is_operation(std::uint32_t sample) const;
  /// Whether it is an event that nothing accounts for, whose words say that it is on in a healthy plant.
  bool is_asked(std::uint32_t sample) const;
};

std::vector<Correspondence> correspondences_of(const ReportInput& input);
void add_left_over(const ReportInput& input, Report& report);
void add_direction_conflicts(const ReportInput& input, Report& report);
void add_questions(const ReportInput& input, Report& report);
/// Adds near misses and open links. O(operations) look-ups in an index of words, each of bounded cost.
void add_near_misses(const ReportInput& input, Report& report);

}  // namespace symplant::infer
