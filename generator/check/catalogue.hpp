// Every rule of the tool, those of reading included, and the check of a plant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diag/diagnostic.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// Adds all findings about a plant, rule by rule in the order of the tables. O(symbols + states) for each rule; runs up
/// to `threads` rules at once; if 0, up to base::threads_for() the symbols.
void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics,
                 std::size_t threads = 0);

/// All rules, by id.
const std::vector<const diag::RuleInfo*>& catalogue();

/// The rule of an id (`SP201`), a slug or a former name, without regard to case; null for an unknown or a removed one.
const diag::RuleInfo* find_rule(std::string_view id_or_slug);
/// For a message, if an earlier version had a rule of this name: "`nobody-moves` is now `event-not-driven`", "the rule
/// `SP312` no longer exists"; else empty.
std::string former_rule(std::string_view name);
/// For a message: that no rule has this name, and the nearest name.
std::string no_such_rule(std::string_view name);

/// Whether a finding stops the commands that use the plant: an error, unless the plant can be served in spite of it.
bool is_stopping(const diag::Diagnostic& finding);
bool has_stopping_errors(const diag::Diagnostics& findings);

}  // namespace symplant::check
