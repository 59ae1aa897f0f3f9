// Reference traces: the lines of a run's trace that they keep.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::suite {

/// Which symbols and locations a reference trace has.
struct Chosen {
  const std::vector<std::string>* only;             ///< patterns of names; empty: operations
  std::unordered_set<std::string_view> operations;  ///< their names
};

/// A trace with the header and the lines of what is chosen, without what changes from build to build (the digests of
/// programs). The header has the `end` of the run. Empty if the trace has no header. O(trace).
std::string reference_text(std::istream& trace, const Chosen& chosen, tables::Time end);

/// The name of the plant in the header of a trace.
std::string plant_of(std::istream& trace);

}  // namespace symplant::suite
