// A request of a client link that the PLC refused, in words.
#pragma once

#include <string>

#include "symplant/tables/refusal.hpp"

namespace symplant::link {

/// "function 15 (write coils) from 800 on: exception 02 (...): ..."; "reading from D100 on: end code 4031 (...): ...":
/// what was refused, why, and what to do. The side is modbus_client or slmp_client.
std::string client_refusal_text(const tables::Refusal& refusal);

}  // namespace symplant::link
