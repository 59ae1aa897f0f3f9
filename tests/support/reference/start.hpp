// The world before the first instant.
#pragma once

#include "support/reference/round.hpp"

namespace symplant::reference {

InstantNotes empty_notes(const Rules& rules);
World first_world(const Rules& rules);

}  // namespace symplant::reference
