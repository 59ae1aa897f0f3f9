// The link `slmp`: the plant is an SLMP client, the PLC a server.
#pragma once

#include <string>
#include <string_view>

#include "symplant/link/client/parts.hpp"

namespace symplant::link::slmp {

/// Why `rest`, the URL after `slmp:`, is invalid; empty if it is valid.
std::string slmp_fault(std::string_view rest);

/// Opens nothing yet. An invalid map is a usage error.
client::PartsResult slmp_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

}  // namespace symplant::link::slmp
