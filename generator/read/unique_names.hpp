// Names of variables that several programs or lists declare.
#pragma once

#include "read/table_builder.hpp"

namespace symplant::read {

/// Names that occur several times become `SCOPE.NAME` in all rows that have a scope; all others stay as they are. Adds
/// a decision about the changes.
void qualify_repeated_names(TableBuilder& builder);

}  // namespace symplant::read
