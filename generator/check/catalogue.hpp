// Every rule of the tool, those of reading included.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::check {

/// By id.
std::vector<const diag::RuleInfo*> catalogue();

/// The rule of an id (`SP201`), a slug or a former slug, without regard to case; null for an unknown one.
const diag::RuleInfo* find_rule(std::string_view id_or_slug);

/// The slug that replaces a former one, without regard to case; empty if `slug` is not a former one.
std::string_view slug_now(std::string_view slug);

/// For a message: "`nobody-moves` is now `event-not-driven`".
std::string renamed_rule(std::string_view former);

/// For a message: no rule has this name, and the nearest one.
std::string no_such_rule(std::string_view name);

/// Whether a finding stops the commands that use the plant: an error, unless it is only that the plant has no device
/// (SP415). The symbols of such a plant can still be served.
bool is_stopping(const diag::Diagnostic& finding);
bool has_stopping_errors(const diag::Diagnostics& findings);

}  // namespace symplant::check
