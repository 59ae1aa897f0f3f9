// The runtime's version as text.
#include "symplant/tables/version.hpp"

namespace symplant::tables {

const char* version() noexcept { return "0.1.0"; }
static_assert(kVersionMajor == 0 && kVersionMinor == 1 && kVersionPatch == 0,
              "version() and the constants in version.hpp differ; give both the same version");

}  // namespace symplant::tables
