// Names of variables that several programs or lists declare.
#pragma once

#include "read/table_builder.hpp"

namespace symplant::read {

/// Names of which there are several become `SCOPE.NAME`, in all rows that have a scope; all others stay as they are.
/// Decides about them.
void qualify_repeated_names(TableBuilder& builder);

}  // namespace symplant::read
