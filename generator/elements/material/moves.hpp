// Resolves transfers, work and sources.
#pragma once

#include <string>
#include <unordered_set>

#include "elements/material/lookup.hpp"

namespace symplant::model {

/// Names of one list, which are unique without regard to case.
using TakenNames = std::unordered_set<std::string>;

Transfer resolve_transfer(const description::GivenTransfer& given, const MadeBy& by, MaterialLookup& lookup,
                          TakenNames& taken);
Work resolve_work(const description::GivenWork& given, const MadeBy& by, MaterialLookup& lookup, TakenNames& taken);
Source resolve_source(const description::GivenSource& given, const MadeBy& by, MaterialLookup& lookup,
                      TakenNames& taken);

}  // namespace symplant::model
