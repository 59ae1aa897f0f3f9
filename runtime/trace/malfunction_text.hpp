// The words of traces and of the panel for what starts and ends malfunctions.
#pragma once

#include <optional>
#include <string_view>

#include "symplant/engine/instant.hpp"

namespace symplant::trace {

/// `scenario`, `hand`, `condition`, `chance`, `becomes`, `end`.
std::string_view malfunction_by(engine::MalfunctionChange::By by);

/// The cause that such a word names; nothing for another word.
std::optional<engine::MalfunctionChange::By> malfunction_by_named(std::string_view word);

}  // namespace symplant::trace
