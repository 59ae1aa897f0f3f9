// What devices should come to, spread over exact names and patterns that resolve to just that.
#pragma once

#include <vector>

#include "property/files/resolve_entries.hpp"

namespace symplant::property::files {

/// Entries of `devices`. `wishes`: all devices of the plant, also those of which nothing is said.
std::vector<Entry> spread(const std::vector<Wish>& wishes, const Style& style, Counts& counts);

}  // namespace symplant::property::files
