// A request of a client link that the PLC refused, in words.
#include "symplant/link/client_refusal.hpp"

#include "symplant/link/modbus/client_codec.hpp"
#include "symplant/link/slmp/refusal.hpp"

namespace symplant::link {

std::string client_refusal_text(const tables::Refusal& refusal) {
  if (refusal.side == tables::Refusal::Side::slmp_client) return slmp::refusal_text(refusal);
  return modbus::refusal_text(refusal);
}

}  // namespace symplant::link
