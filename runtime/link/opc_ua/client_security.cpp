// What a link `opc-ua` needs to connect with security.
#include "symplant/link/opc_ua/client_security.hpp"

#include <open62541/client_config_default.h>
#include <open62541/plugin/pki_default.h>
#include <open62541/plugin/securitypolicy_default.h>

#include <string_view>
#include <utility>
#include <variant>

#include "symplant/link/opc_ua/address.hpp"
#include "symplant/link/opc_ua/application_uri.hpp"

namespace symplant::link::opc_ua {

namespace {

constexpr std::string_view kApplicationUri = "urn:symplant";

/// A key with a password: the link cannot ask for it.
UA_StatusCode no_password(UA_ClientConfig* /*config*/, UA_ByteString* /*password*/) {
  return UA_STATUSCODE_BADSECURITYCHECKSFAILED;
}

UA_StatusCode set_text(UA_String& field, std::string_view text) {
  UA_String_clear(&field);
  const UA_String view = view_of(text);
  return UA_String_copy(&view, &field);
}

}  // namespace

std::variant<ClientSecurity, LinkError> ClientSecurity::load(const SecuritySettings& settings) {
  ClientSecurity security(settings);
  if (settings.security == Security::none) return security;
  if (auto error = security.read_files()) return std::move(*error);
  if (auto error = security.try_out()) return std::move(*error);
  return security;
}

std::optional<LinkError> ClientSecurity::read_files() {
  auto own = own_certificate(settings_, "symplant", std::string(kApplicationUri));
  if (auto* error = std::get_if<LinkError>(&own)) return std::move(*error);
  if (!settings_.trust.empty()) {
    auto trusted = TrustedCertificates::read(settings_.trust);
    if (auto* error = std::get_if<LinkError>(&trusted)) return std::move(*error);
    trusted_ = std::move(std::get<TrustedCertificates>(trusted));
  }
  if (!settings_.password_file.empty()) {
    auto password = read_password(settings_.password_file);
    if (auto* error = std::get_if<LinkError>(&password)) return std::move(*error);
    password_ = std::move(std::get<std::string>(password));
  }
  own_ = std::move(std::get<OwnCertificate>(own));
  return std::nullopt;
}

/// Whether open62541 accepts the certificate and the key, and they belong together.
std::optional<LinkError> ClientSecurity::try_out() const {
  UA_ClientConfig config{};
  config.logging = silent();
  const UA_StatusCode status = configure(config);
  std::optional<LinkError> other_key;
  if (status == UA_STATUSCODE_GOOD) other_key = pair_fault(settings_, config.securityPolicies[1]);
  UA_ClientConfig_clear(&config);
  if (status == UA_STATUSCODE_GOOD) return other_key;
  if (status == UA_STATUSCODE_BADCERTIFICATEURIINVALID) {
    return usage_error("`certificate=" + settings_.certificate +
                       "`: it has no URI among its alternative names, which OPC UA needs: make one with "
                       "URI:urn:symplant, as docs/opc-ua.md shows");
  }
  return usage_error("`certificate=" + settings_.certificate + "&key=" + settings_.key +
                     "`: open62541 does not accept them: give an RSA key of 2048 bits or more, without a password");
}

UA_StatusCode ClientSecurity::configure(UA_ClientConfig& config) const {
  config.privateKeyPasswordCallback = no_password;
  if (!own_) {
    return UA_ClientConfig_setDefault(&config) | set_text(config.clientDescription.applicationUri, kApplicationUri);
  }
  UA_StatusCode status =
      UA_ClientConfig_setDefaultEncryption(&config, *own_->certificate, *own_->key, nullptr, 0, nullptr, 0);
  if (status != UA_STATUSCODE_GOOD) return status;
  if (config.securityPoliciesSize < 2) return UA_STATUSCODE_BADCERTIFICATEINVALID;  // only None: a bad key
  const std::string uri = application_uri_of(text_of(config.securityPolicies[1].localCertificate));
  if (uri.empty()) return UA_STATUSCODE_BADCERTIFICATEURIINVALID;
  status = set_text(config.clientDescription.applicationUri, uri);
  // check() has compared the certificate byte by byte, and open62541 compares the peer's with it.
  if (config.certificateVerification.clear != nullptr) {
    config.certificateVerification.clear(&config.certificateVerification);
  }
  UA_CertificateVerification_AcceptAll(&config.certificateVerification);
  if (settings_.user.empty()) return status;
  return status | UA_ClientConfig_setAuthenticationUsername(&config, settings_.user.c_str(), password_.c_str());
}

/// Null: of the link's own one.
std::string ClientSecurity::fingerprint(const UA_ByteString* certificate) const {
  UA_SecurityPolicy policy{};
  if (UA_SecurityPolicy_Basic256Sha256(&policy, *own_->certificate, *own_->key, silent()) != UA_STATUSCODE_GOOD)
    return {};
  std::string text = "SHA-1 " + thumbprint(policy, certificate == nullptr ? policy.localCertificate : *certificate);
  policy.clear(&policy);
  return text;
}

std::string ClientSecurity::own_fingerprint() const { return fingerprint(nullptr); }

std::string ClientSecurity::check(const UA_ByteString& certificate) {
  if (!own_) return {};
  const std::string shown = fingerprint(&certificate);
  if (trusted_) {
    if (!trusted_->has(certificate)) {
      return "the certificate of the server (" + shown + ") is not in the folder `" + settings_.trust +
             "` of `trust`: compare it with that of the PLC, and put it there if it is the same";
    }
    note_ = "its certificate (" + shown + ") is trusted";
    return {};
  }
  if (!accepted_.empty() && accepted_ != text_of(certificate)) {
    return "the server now has another certificate (" + shown +
           ") than at the first connection of this run; start the run again if the PLC was given a new one";
  }
  note_ = "its certificate (" + shown + ") was accepted without a check, since the link has no `trust`";
  return {};
}

}  // namespace symplant::link::opc_ua
