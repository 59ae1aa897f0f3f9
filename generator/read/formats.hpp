// The readers, one for each format; each is defined in its file in formats/.
#pragma once

#include "read/reader.hpp"

namespace symplant::read {

extern const ReaderInfo kGxIec;

}  // namespace symplant::read
