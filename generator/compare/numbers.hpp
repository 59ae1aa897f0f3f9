// Where numbers of two traces differ.
#pragma once

#include <vector>

#include "compare/difference.hpp"
#include "compare/offsets.hpp"

namespace symplant::compare {

struct Limits {
  tables::Time window;
  double tolerance;    ///< as a share of EXPECTED's span
  tables::Time until;  ///< in EXPECTED's time
};

/// Adds a difference wherever `actual`, which may be null, differs from `expected` by more than the tolerance, for
/// longer than the window. Before its first change a number is 0. O(changes).
void add_deviations(const Series& expected, const Series* actual, const Offsets& offsets, const Limits& limits,
                    std::vector<Difference>& differences);

}  // namespace symplant::compare
