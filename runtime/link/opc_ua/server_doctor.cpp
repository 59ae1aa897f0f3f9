// Listens as an OPC UA server and notes what clients read and write.
#include "symplant/link/opc_ua/server_doctor.hpp"

namespace symplant::link::opc_ua {

doctor::Examined examine_server(std::string_view /*rest*/, const LinkChoice& /*link*/,
                                const tables::PlantTables& /*tables*/, const doctor::Options& /*options*/) {
  return LinkError{LinkError::Kind::environment, "the link `opc-ua-server` is not finished"};
}

}  // namespace symplant::link::opc_ua
