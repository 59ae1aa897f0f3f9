// What a proposed naming rule explains of the lists, what it does not, and what a person should decide.
#pragma once

#include <cstddef>
#include <set>
#include <span>

#include "infer/report_data.hpp"

namespace symplant::infer {

/// `naming` must be valid. Apart from examples of equal rank it does not depend on the order of the samples. O(text).
Report report_of(const name::Naming& naming, std::span<const Sample> samples);

/// The score of a valid naming rule.
name::Counts score_of(const name::Naming& naming, std::span<const Sample> samples);

/// The naming rule without some correspondences, and with some questions as constants. The sets hold indexes.
name::Naming with_answers(const name::Naming& naming, const Report& report, const std::set<std::size_t>& refused,
                          const std::set<std::size_t>& accepted);

}  // namespace symplant::infer
