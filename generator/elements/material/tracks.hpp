// Resolves tracks and places.
#pragma once

#include <vector>

#include "elements/material/lookup.hpp"

namespace symplant::model {

/// Completes a track that has its name and length.
void resolve_track(const description::GivenTrack& given, const MadeBy& by, MaterialLookup& lookup, Track& track);

/// Completes a place that has its name.
void resolve_place(const description::GivenPlace& given, const MadeBy& by, MaterialLookup& lookup, Place& place);

}  // namespace symplant::model
