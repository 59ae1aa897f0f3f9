// A link that goes to the PLC: polls its operations and writes its events, in any protocol that has a Dialog.
#pragma once

#include "symplant/link/client/parts.hpp"
#include "symplant/link/link.hpp"

namespace symplant::link::client {

/// Starts a thread that connects to the PLC, and reconnects after each failure. It reads all operations; writes the
/// events that changed; writes all of them after a connection and after each `refresh`. It writes only to a PLC whose
/// identity is verified, or with LinkSettings::arm to one that has nothing to verify. Tables must outlive the link; a
/// system without threads is an error.
LinkResult open_client_link(ClientParts parts, const LinkSettings& settings, const tables::PlantTables& tables,
                            const plant::Plant* plant);

}  // namespace symplant::link::client
