// The links of OPC UA in a build without open62541: an error for each.
#include "symplant/link/opc_ua/client_link_parts.hpp"
#include "symplant/link/opc_ua/server_doctor.hpp"
#include "symplant/link/opc_ua/server_link.hpp"

namespace symplant::link::opc_ua {

namespace {

LinkError absent() {
  return {LinkError::Kind::environment,
          "this symplant was built without OPC UA: build it on a system with open62541 1.4, such as Debian 13"};
}

}  // namespace

LinkResult open_server_link(std::string_view /*rest*/, const LinkChoice& /*link*/,
                            const tables::PlantTables& /*tables*/, const plant::Plant* /*plant*/) {
  return absent();
}

doctor::Examined examine_server(std::string_view /*rest*/, const LinkChoice& /*link*/,
                                const tables::PlantTables& /*tables*/, const doctor::Options& /*options*/) {
  return absent();
}

client::PartsResult client_link_parts(std::string_view /*rest*/, const LinkChoice& /*link*/,
                                      const tables::PlantTables& /*tables*/) {
  return absent();
}

}  // namespace symplant::link::opc_ua
