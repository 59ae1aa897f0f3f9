// The link `slmp`: the plant is an SLMP client, the PLC a server.
#pragma once

#include <string>
#include <string_view>

#include "symplant/link/link.hpp"

namespace symplant::link::slmp {

/// Why `rest`, the URL after `slmp:`, is invalid; empty if it is valid.
std::string slmp_fault(std::string_view rest);

/// Starts the client. Tables must outlive it. An invalid map is a usage error.
LinkResult open_slmp_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                          const plant::Plant* plant);

}  // namespace symplant::link::slmp
