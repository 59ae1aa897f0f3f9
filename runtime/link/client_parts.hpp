// The parts of a link that goes to a PLC, by its URL: for the link itself and for tools that look at the PLC.
#pragma once

#include <string_view>

#include "symplant/link/client/parts.hpp"

namespace symplant::link {

/// Whether the URL is that of a link that goes to a PLC. O(1).
bool is_client(std::string_view url);

/// The parts of such a link. Opens no connection. Tables must outlive the result.
client::PartsResult client_parts(const LinkChoice& link, const tables::PlantTables& tables);

}  // namespace symplant::link
