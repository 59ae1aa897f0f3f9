// A request of a client link that the PLC refused, in words.
#pragma once

#include <string>

#include "symplant/tables/refusal.hpp"

namespace symplant::link {

/// "reading from D100 on: end code 4031 (...): ...": what was refused, why, and what to do, in the words of the
/// protocol. The side is that of a link that goes to the PLC.
std::string client_refusal_text(const tables::Refusal& refusal);

}  // namespace symplant::link
