// Marks the transitions and units that need a record in the engine.
#pragma once

#include "lower/engine_tables.hpp"

namespace symplant::lower {

/// Sets tables::Transition::timed and tables::UnitRow::rich. All other tables must be complete. O(transitions of all
/// units).
void mark_what_costs_more(EngineTables& tables);

}  // namespace symplant::lower
