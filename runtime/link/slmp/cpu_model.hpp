// The CPU model that a PLC reports, compared with the family of the link.
#pragma once

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/slmp/framing.hpp"

namespace symplant::link::slmp {

/// The identity in the reply to Command::read_model.
client::Identity identity_of(const Reply& reply, const Framing& framing);

}  // namespace symplant::link::slmp
