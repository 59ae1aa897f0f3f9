// The readers, one for each format; each is defined in its file in formats/.
#pragma once

#include "read/reader.hpp"

namespace symplant::read {

extern const ReaderInfo kAnyTable;
extern const ReaderInfo kCodesysIoMapping;
extern const ReaderInfo kGxIec;
extern const ReaderInfo kGxWorksComments;
extern const ReaderInfo kGxWorksLabels;
extern const ReaderInfo kKepware;
extern const ReaderInfo kLsGlobals;
extern const ReaderInfo kLsTags;
extern const ReaderInfo kTiaTags;

}  // namespace symplant::read
