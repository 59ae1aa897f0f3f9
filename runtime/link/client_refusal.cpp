// A request of a client link that the PLC refused, in words.
#include "symplant/link/client_refusal.hpp"

#include "symplant/link/kinds.hpp"

namespace symplant::link {

std::string client_refusal_text(const tables::Refusal& refusal) {
  for (const Kind& kind : kinds()) {
    if (kind.parts != nullptr && kind.side == refusal.side) return kind.refusal_text(refusal);
  }
  return {};
}

}  // namespace symplant::link
