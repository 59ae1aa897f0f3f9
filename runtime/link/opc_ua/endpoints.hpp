// Chooses one of the endpoints that a server offers; only for .cpp files of this folder.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

/// An endpoint, and how to log in there. Both point into the list.
struct ChosenEndpoint {
  const UA_EndpointDescription* endpoint = nullptr;
  const UA_UserTokenPolicy* token = nullptr;
};

/// The endpoint of the highest security level that has the security and the kind of login of the settings. With
/// Security::sign one that also encrypts is good, too. A password is never sent without encryption. Otherwise nothing,
/// and `problem` says what the server offers and what to do. O(endpoints).
std::optional<ChosenEndpoint> choose_endpoint(std::span<const UA_EndpointDescription> endpoints,
                                              const SecuritySettings& settings, std::string& problem);

}  // namespace symplant::link::opc_ua
