// The link `opc-ua`.
#include "symplant/link/opc_ua/client_link_parts.hpp"

namespace symplant::link::opc_ua {

client::PartsResult client_link_parts(std::string_view /*rest*/, const LinkChoice& /*link*/,
                                      const tables::PlantTables& /*tables*/) {
  return LinkError{LinkError::Kind::environment, "the link `opc-ua` is not finished"};
}

std::string refusal_text(const tables::Refusal& /*refusal*/) { return {}; }

}  // namespace symplant::link::opc_ua
