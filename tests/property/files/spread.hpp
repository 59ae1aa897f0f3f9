// Spreads the wanted description of devices over exact names and patterns that resolve to it.
#pragma once

#include <vector>

#include "property/files/resolve_entries.hpp"

namespace symplant::property::files {

/// Entries of `devices`. `wishes`: all devices of the plant, including those without keys.
std::vector<Entry> spread(const std::vector<Wish>& wishes, const Style& style, Counts& counts);

}  // namespace symplant::property::files
