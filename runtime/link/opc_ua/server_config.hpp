// The configuration of the server: address, endpoints, users, certificates, limits.
#pragma once

#include <open62541/server.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "symplant/link/net/host_port.hpp"
#include "symplant/link/opc_ua/certificates.hpp"
#include "symplant/link/opc_ua/messages.hpp"
#include "symplant/link/opc_ua/server_settings.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::opc_ua {

/// Sizes on which the limits of the server depend.
struct ServerLimits {
  std::size_t nodes = 0;                      ///< variables of the plant
  std::uint32_t connections = 0;              ///< as in LinkSettings; at least kLeastSessions sessions are possible
  tables::Time idle = 300 * tables::kSecond;  ///< longest time of a session without a request; 0: no limit

  static constexpr std::uint32_t kLeastSessions = 50;  ///< as in OPC UA's profile "Standard 2017"
};

/// What the configuration's functions use; it must outlive the server.
struct ServerAccess {
  Messages& messages;
  std::optional<TrustedCertificates> trusted;                      ///< nothing: any certificate is accepted
  void* owner = nullptr;                                           ///< for the functions of nodes
  decltype(UA_AccessControl::activateSession) activate = nullptr;  ///< open62541's own check of users
};

/// UA_ServerConfig::context of a server of this folder.
inline ServerAccess& access_of(UA_Server* server) {
  return *static_cast<ServerAccess*>(UA_Server_getConfig(server)->context);
}

struct DeleteServer {
  void operator()(UA_Server* server) const noexcept { UA_Server_delete(server); }
};
using OwnedServer = std::unique_ptr<UA_Server, DeleteServer>;

/// A server without nodes that listens at settings.address when it is started. With security, it reads the settings'
/// files, whose errors are of kind usage, and adds messages on its certificate to `access.messages`.
std::variant<OwnedServer, LinkError> make_server(const ServerSettings& settings, const ServerLimits& limits,
                                                 const std::string& plant, ServerAccess& access);

}  // namespace symplant::link::opc_ua
