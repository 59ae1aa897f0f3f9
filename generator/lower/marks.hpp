// Which transitions and units the engine keeps a record of.
#pragma once

#include "lower/engine_tables.hpp"

namespace symplant::lower {

/// Sets tables::Transition::timed and tables::UnitRow::rich, once all other tables stand. O(transitions of all units).
void mark_what_costs_more(EngineTables& tables);

}  // namespace symplant::lower
