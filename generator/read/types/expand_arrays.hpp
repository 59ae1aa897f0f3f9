// Gives each element of an array of inputs or outputs a row.
#pragma once

#include "address/address.hpp"
#include "diag/diagnostic.hpp"
#include "read/symbol_table.hpp"

namespace symplant::read {

/// Replaces each row of an array of an elementary type that has the address of an input or output of the element's size
/// by rows of its elements: `NAME[0]`, `NAME[0,3]`, with the element's address, the comment, line and location of the
/// row, and no initial value. `radix` is that of X and Y. Other rows stay as they are. At most 4,096 elements of an
/// array and 65,536 of a list; the others are left out, with a warning.
void expand_arrays(SymbolTable& table, address::Radix radix, diag::Diagnostics& diagnostics);

}  // namespace symplant::read
