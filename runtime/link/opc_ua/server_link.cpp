// The link `opc-ua-server`.
#include "symplant/link/opc_ua/server_link.hpp"

namespace symplant::link::opc_ua {

LinkResult open_server_link(std::string_view /*rest*/, const LinkChoice& /*link*/,
                            const tables::PlantTables& /*tables*/, const plant::Plant* /*plant*/) {
  return LinkError{LinkError::Kind::environment, "the link `opc-ua-server` is not finished"};
}

}  // namespace symplant::link::opc_ua
