// The configuration of the server.
#include "symplant/link/opc_ua/server_config.hpp"

#include <open62541/plugin/accesscontrol_default.h>
#include <open62541/plugin/pki_default.h>
#include <open62541/server_config_default.h>

#include <algorithm>
#include <utility>

#include "symplant/link/opc_ua/address.hpp"
#include "symplant/link/opc_ua/application_uri.hpp"
#include "symplant/link/opc_ua/server_nodes.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::link::opc_ua {

namespace {

constexpr std::string_view kNonePolicy = "http://opcfoundation.org/UA/SecurityPolicy#None";
constexpr std::string_view kSecurePolicy = "http://opcfoundation.org/UA/SecurityPolicy#Basic256Sha256";
constexpr double kShortestInterval = 10;            // ms; of publishing, and of sampling what is not of the plant
constexpr double kLongestInterval = 3600.0 * 1000;  // ms; of sampling, and of a session without a request
constexpr double kLongestPublishing = 10.0 * 1000;  // ms
constexpr std::uint32_t kMostKeepAliveCount = 5;    ///< publishing intervals until a silent client must answer
constexpr std::uint32_t kMostMessage = 16 * 1024 * 1024;
constexpr std::uint32_t kSubscriptionsOfSession = 20;
constexpr std::uint32_t kMoreChannels = 10;  ///< than sessions, for clients that only ask for endpoints
constexpr std::uint32_t kMostQueue = 1000;

UA_String copy_of(std::string_view text) {
  UA_String copy = UA_STRING_NULL;
  const UA_String view = view_of(text);
  UA_String_copy(&view, &copy);
  return copy;
}

void replace(UA_String& string, std::string_view text) {
  UA_String_clear(&string);
  string = copy_of(text);
}

/// Owns a configuration until a server takes it over.
class Config {
 public:
  Config() { config_.logging = silent(); }
  Config(const Config&) = delete;
  Config& operator=(const Config&) = delete;
  ~Config() { UA_ServerConfig_clean(&config_); }

  UA_ServerConfig* operator->() noexcept { return &config_; }
  UA_ServerConfig* get() noexcept { return &config_; }
  OwnedServer server() noexcept { return OwnedServer(UA_Server_newWithConfig(&config_)); }

 private:
  UA_ServerConfig config_{};
};

void describe(UA_ServerConfig& config, const std::string& plant) {
  replace(config.applicationDescription.applicationUri, plant_uri("urn:symplant:server:", plant));
  replace(config.applicationDescription.productUri, "urn:symplant");
  UA_LocalizedText_clear(&config.applicationDescription.applicationName);
  config.applicationDescription.applicationName = {UA_STRING_NULL, copy_of("symplant " + plant)};
  replace(config.buildInfo.productUri, "urn:symplant");
  replace(config.buildInfo.manufacturerName, "symplant");
  replace(config.buildInfo.productName, "symplant");
  replace(config.buildInfo.softwareVersion, tables::version());
  replace(config.buildInfo.buildNumber, tables::version());
  config.buildInfo.buildDate = 0;
}

/// To open62541 an empty host means all addresses of this machine.
std::string listening_url(const net::HostPort& address) {
  const bool all = address.host == "0.0.0.0" || address.host == "::";
  return "opc.tcp://" + net::format_host_port({all ? std::string() : address.host, address.port});
}

void listen_at(UA_ServerConfig& config, const net::HostPort& address) {
  UA_Array_delete(config.serverUrls, config.serverUrlsSize, &UA_TYPES[UA_TYPES_STRING]);
  config.serverUrls = static_cast<UA_String*>(UA_Array_new(1, &UA_TYPES[UA_TYPES_STRING]));
  config.serverUrlsSize = 1;
  *config.serverUrls = copy_of(listening_url(address));
}

void limit(UA_ServerConfig& config, const ServerLimits& limits) {
  const auto nodes = static_cast<std::uint32_t>(std::max<std::size_t>(limits.nodes, 1000));
  const std::uint32_t sessions = std::max(limits.connections, ServerLimits::kLeastSessions);
  config.maxSessions = static_cast<UA_UInt16>(sessions);
  config.maxSecureChannels = static_cast<UA_UInt16>(sessions + kMoreChannels);
  config.maxSessionTimeout = limits.idle == 0 ? kLongestInterval : static_cast<double>(limits.idle) / 1e6;
  config.tcpMaxMsgSize = kMostMessage;
  config.maxNodesPerRead = nodes;
  config.maxNodesPerWrite = nodes;
  config.maxNodesPerBrowse = nodes;
  config.maxNodesPerRegisterNodes = nodes;
  config.maxNodesPerTranslateBrowsePathsToNodeIds = nodes;
  config.maxNodesPerMethodCall = 100;
  config.maxMonitoredItemsPerCall = nodes;
  config.maxSubscriptionsPerSession = kSubscriptionsOfSession;
  config.maxSubscriptions = sessions * kSubscriptionsOfSession;
  config.maxMonitoredItemsPerSubscription = 2 * nodes;
  config.maxNotificationsPerPublish = nodes;
  config.maxPublishReqPerSession = 100;
  config.maxRetransmissionQueueSize = 100;
  config.publishingIntervalLimits = {kShortestInterval, kLongestPublishing};
  config.keepAliveCountLimits = {1, kMostKeepAliveCount};
  config.samplingIntervalLimits = {kShortestInterval, kLongestInterval};
  config.queueSizeLimits = {1, kMostQueue};
}

std::string quoted_user(const UA_ExtensionObject& token) {
  if (token.encoding < UA_EXTENSIONOBJECT_DECODED ||
      token.content.decoded.type != &UA_TYPES[UA_TYPES_USERNAMEIDENTITYTOKEN]) {
    return "without a user name";
  }
  const auto& user = *static_cast<const UA_UserNameIdentityToken*>(token.content.decoded.data);
  return "with the user name `" + of_peer(text_of(user.userName)) + "` and a wrong password or name";
}

UA_StatusCode activate_session(UA_Server* server, UA_AccessControl* control, const UA_EndpointDescription* endpoint,
                               const UA_ByteString* certificate, const UA_NodeId* session,
                               const UA_ExtensionObject* token, void** context) {
  ServerAccess& access = access_of(server);
  const UA_StatusCode status = access.activate(server, control, endpoint, certificate, session, token, context);
  if (status != UA_STATUSCODE_GOOD) {
    access.messages.add_once(Messages::Cause::user,
                             "a client " + quoted_user(*token) + " was refused (" + status_name(status) + ")");
  }
  return status;
}

/// Before the server adds an item that monitors a value, it reads the value, and so calls this; then it looks at the
/// limits of the configuration. It must not sample the plant's variables: their changes are written, and a write looks
/// at every item with the sampling interval 0.
UA_Byte user_access_level(UA_Server* server, UA_AccessControl* /*control*/, const UA_NodeId* /*session*/,
                          void* /*session_context*/, const UA_NodeId* /*node*/, void* node_context) {
  UA_DurationRange& sampling = UA_Server_getConfig(server)->samplingIntervalLimits;
  sampling = node_context != nullptr ? UA_DurationRange{0, 0} : UA_DurationRange{kShortestInterval, kLongestInterval};
  return 0xFF;
}

template <class... Arguments>
UA_Boolean refuse(Arguments...) {
  return false;
}

/// Clients may not change the nodes.
void forbid_changes(UA_AccessControl& control) {
  control.allowAddNode = refuse;
  control.allowAddReference = refuse;
  control.allowDeleteNode = refuse;
  control.allowDeleteReference = refuse;
}

/// Anonymous without security, else one user, whose password is encrypted by the secure policy.
UA_StatusCode set_users(UA_ServerConfig& config, const std::string& user, const std::string& password,
                        ServerAccess& access) {
  const bool secure = !user.empty();
  const UA_UsernamePasswordLogin login{view_of(user), view_of(password)};
  const UA_ByteString policy = view_of(secure ? kSecurePolicy : kNonePolicy);
  // Without a verification of sessions there are no users by certificate.
  const UA_CertificateVerification sessions = std::exchange(config.sessionPKI, {});
  const UA_StatusCode status = UA_AccessControl_default(&config, !secure, &policy, secure ? 1 : 0, &login);
  config.sessionPKI = sessions;
  access.activate = std::exchange(config.accessControl.activateSession, activate_session);
  config.accessControl.getUserAccessLevel = user_access_level;
  forbid_changes(config.accessControl);
  return status;
}

UA_StatusCode verify_certificate(const UA_CertificateVerification* verification, const UA_ByteString* certificate) {
  const UA_ServerConfig& config = *static_cast<const UA_ServerConfig*>(verification->context);
  ServerAccess& access = *static_cast<ServerAccess*>(config.context);
  if (access.trusted->has(*certificate)) return UA_STATUSCODE_GOOD;
  const UA_SecurityPolicy& secure = config.securityPolicies[config.securityPoliciesSize - 1];
  access.messages.add_once(Messages::Cause::certificate, "a client was refused: its certificate with the thumbprint " +
                                                             thumbprint(secure, *certificate) +
                                                             " is not in the folder `trust`");
  return UA_STATUSCODE_BADCERTIFICATEUNTRUSTED;
}

LinkError environment(const char* what, UA_StatusCode status) {
  return {LinkError::Kind::environment,
          std::string("cannot start the OPC UA server: ") + what + " (" + status_name(status) + ")"};
}

/// Why the files of the settings are no certificate of this server.
std::optional<LinkError> certificate_fault(const SecuritySettings& settings, const UA_SecurityPolicy& policy,
                                           std::string_view uri) {
  if (auto error = pair_fault(settings, policy)) return error;
  const std::string has = application_uri_of(text_of(policy.localCertificate));
  if (has == uri) return std::nullopt;
  return usage_error("`certificate=" + settings.certificate + "`: its application URI is " +
                     (has.empty() ? "missing" : "`" + of_peer(has) + "`") + ", that of the server is `" +
                     std::string(uri) + "`: clients would refuse it; see \"Use security\" in docs/opc-ua.md");
}

/// Adds the secure policy with its endpoints; the policy None remains for clients that ask which endpoints there are.
std::optional<LinkError> secure(UA_ServerConfig& config, const SecuritySettings& settings, const std::string& plant,
                                ServerAccess& access) {
  if (!settings.trust.empty()) {
    auto trusted = TrustedCertificates::read(settings.trust);
    if (auto* error = std::get_if<LinkError>(&trusted)) return std::move(*error);
    access.trusted = std::move(std::get<TrustedCertificates>(trusted));
  }
  auto password = read_password(settings.password_file);
  if (auto* error = std::get_if<LinkError>(&password)) return std::move(*error);
  auto made = own_certificate(settings, "symplant " + plant,
                              std::string(text_of(config.applicationDescription.applicationUri)));
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  const auto& own = std::get<OwnCertificate>(made);

  config.securityPolicyNoneDiscoveryOnly = true;
  UA_StatusCode status = UA_ServerConfig_addSecurityPolicyBasic256Sha256(&config, own.certificate.get(), own.key.get());
  if (status != UA_STATUSCODE_GOOD) {
    return own.made ? environment("its certificate", status)
                    : usage_error("`certificate=" + settings.certificate + "&key=" + settings.key +
                                  "`: not a certificate and its private key without a password, in DER or PEM");
  }
  const UA_SecurityPolicy& added = config.securityPolicies[config.securityPoliciesSize - 1];
  if (auto error = certificate_fault(settings, added, text_of(config.applicationDescription.applicationUri))) {
    return error;
  }
  const UA_String policy = view_of(kSecurePolicy);
  if (settings.security == Security::sign) {
    status |= UA_ServerConfig_addEndpoint(&config, policy, UA_MESSAGESECURITYMODE_SIGN);
  }
  status |= UA_ServerConfig_addEndpoint(&config, policy, UA_MESSAGESECURITYMODE_SIGNANDENCRYPT);
  status |= set_users(config, settings.user, std::get<std::string>(password), access);
  if (status != UA_STATUSCODE_GOOD) return environment("its endpoints", status);
  if (own.made) {
    access.messages.add("the server made a certificate for this run, with the thumbprint " +
                        thumbprint(added, added.localCertificate) + "; `certificate=FILE&key=FILE` keeps one");
  }
  if (!access.trusted) {
    access.messages.add("the certificate of every client is accepted; `trust=DIR` accepts only those in a folder");
  }
  return std::nullopt;
}

}  // namespace

std::variant<OwnedServer, LinkError> make_server(const ServerSettings& settings, const ServerLimits& limits,
                                                 const std::string& plant, ServerAccess& access) {
  Config config;
  UA_StatusCode status = UA_ServerConfig_setBasics(config.get());
  if (status != UA_STATUSCODE_GOOD) return environment("its configuration", status);
  config->context = &access;
  describe(*config.get(), plant);
  listen_at(*config.get(), settings.address);
  limit(*config.get(), limits);
  UA_CertificateVerification_AcceptAll(&config->secureChannelPKI);
  UA_CertificateVerification_AcceptAll(&config->sessionPKI);
  status = UA_ServerConfig_addSecurityPolicyNone(config.get(), nullptr);
  if (status != UA_STATUSCODE_GOOD) return environment("its policy", status);
  if (settings.security.security == Security::none) {
    status |= UA_ServerConfig_addEndpoint(config.get(), view_of(kNonePolicy), UA_MESSAGESECURITYMODE_NONE);
    status |= set_users(*config.get(), "", "", access);
    if (status != UA_STATUSCODE_GOOD) return environment("its endpoint", status);
  } else if (auto error = secure(*config.get(), settings.security, plant, access)) {
    return std::move(*error);
  }
  const bool verifies = access.trusted.has_value();
  OwnedServer server = config.server();
  if (!server) return environment("no memory", UA_STATUSCODE_BADOUTOFMEMORY);
  if (verifies) {
    UA_ServerConfig* const owned = UA_Server_getConfig(server.get());
    owned->secureChannelPKI.context = owned;
    owned->secureChannelPKI.verifyCertificate = verify_certificate;
  }
  return server;
}

}  // namespace symplant::link::opc_ua
