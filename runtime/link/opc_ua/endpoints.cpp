// Chooses one of the endpoints that a server offers.
#include "symplant/link/opc_ua/endpoints.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "symplant/link/opc_ua/messages.hpp"

namespace symplant::link::opc_ua {

namespace {

constexpr std::string_view kPolicies = "http://opcfoundation.org/UA/SecurityPolicy#";
constexpr std::array<std::string_view, 3> kSecure = {"Basic256Sha256", "Aes128_Sha256_RsaOaep", "Aes256_Sha256_RsaPss"};

/// "Basic256Sha256".
std::string_view policy_name(const UA_String& uri) {
  const std::string_view text = text_of(uri);
  return text.starts_with(kPolicies) ? text.substr(kPolicies.size()) : text;
}

bool is_secure(std::string_view policy) { return std::find(kSecure.begin(), kSecure.end(), policy) != kSecure.end(); }

bool has_transport(const UA_EndpointDescription& endpoint) {
  const std::string_view profile = text_of(endpoint.transportProfileUri);
  return profile.empty() || profile.ends_with("uatcp-uasc-uabinary");  // an S7-1500 leaves it empty
}

bool has_security(const UA_EndpointDescription& endpoint, Security wanted) {
  const std::string_view policy = policy_name(endpoint.securityPolicyUri);
  switch (wanted) {
    case Security::none:
      return endpoint.securityMode == UA_MESSAGESECURITYMODE_NONE && (policy.empty() || policy == "None");
    case Security::sign:
      return is_secure(policy) && (endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGN ||
                                   endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGNANDENCRYPT);
    case Security::encrypt:
      return is_secure(policy) && endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGNANDENCRYPT;
  }
  return false;
}

/// Whether a password for this kind of login is encrypted, by its own policy or by that of the endpoint.
bool hides_password(const UA_UserTokenPolicy& token, const UA_EndpointDescription& endpoint) {
  const std::string_view policy = policy_name(token.securityPolicyUri);
  if (policy.empty()) return is_secure(policy_name(endpoint.securityPolicyUri));
  return is_secure(policy) || endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGNANDENCRYPT;
}

const UA_UserTokenPolicy* choose_token(const UA_EndpointDescription& endpoint, bool named) {
  const std::span tokens(endpoint.userIdentityTokens, endpoint.userIdentityTokensSize);
  const auto found = std::find_if(tokens.begin(), tokens.end(), [&](const UA_UserTokenPolicy& token) {
    return named ? token.tokenType == UA_USERTOKENTYPE_USERNAME && hides_password(token, endpoint)
                 : token.tokenType == UA_USERTOKENTYPE_ANONYMOUS;
  });
  return found == tokens.end() ? nullptr : &*found;
}

std::string_view mode_name(UA_MessageSecurityMode mode) {
  switch (mode) {
    case UA_MESSAGESECURITYMODE_NONE:
      return "none";
    case UA_MESSAGESECURITYMODE_SIGN:
      return "sign";
    case UA_MESSAGESECURITYMODE_SIGNANDENCRYPT:
      return "encrypt";
    default:
      return "unknown";
  }
}

/// "none, encrypt with Basic256Sha256".
std::string offers(std::span<const UA_EndpointDescription> endpoints) {
  std::set<std::string> all;
  for (const UA_EndpointDescription& endpoint : endpoints) {
    std::string one(mode_name(endpoint.securityMode));
    if (endpoint.securityMode != UA_MESSAGESECURITYMODE_NONE) {
      one.append(" with ").append(of_peer(policy_name(endpoint.securityPolicyUri)));
    }
    all.insert(std::move(one));
  }
  std::string text;
  for (const std::string& one : all) text.append(text.empty() ? "" : ", ").append(one);
  return text.empty() ? "nothing" : text;
}

std::string_view security_name(Security security) {
  return security == Security::none ? "none" : security == Security::sign ? "sign" : "encrypt";
}

}  // namespace

std::optional<ChosenEndpoint> choose_endpoint(std::span<const UA_EndpointDescription> endpoints,
                                              const SecuritySettings& settings, std::string& problem) {
  ChosenEndpoint best;
  bool any = false;  // some endpoint has the security
  for (const UA_EndpointDescription& endpoint : endpoints) {
    if (!has_transport(endpoint) || !has_security(endpoint, settings.security)) continue;
    any = true;
    const UA_UserTokenPolicy* const token = choose_token(endpoint, !settings.user.empty());
    if (token == nullptr) continue;
    if (best.endpoint == nullptr || endpoint.securityLevel > best.endpoint->securityLevel) best = {&endpoint, token};
  }
  if (best.endpoint != nullptr) return best;
  if (!any) {
    problem = "the server does not offer `security=" + std::string(security_name(settings.security)) +
              "`; it offers: " + offers(endpoints) + "; give one of these, or allow it in the server";
  } else if (settings.user.empty()) {
    problem = "the server does not take a client without a user; give `user=NAME&password-file=FILE`" +
              std::string(settings.security == Security::none ? " and `security=encrypt`" : "") +
              ", or allow anonymous clients in the server";
  } else {
    problem =
        "the server does not take users with an encrypted password here; leave out `user`, or allow users in the "
        "server";
  }
  return std::nullopt;
}

}  // namespace symplant::link::opc_ua
