// What a link `opc-ua` needs to connect with security; only for .cpp files of this folder.
#pragma once

#include <open62541/client.h>

#include <optional>
#include <string>

#include "symplant/link/opc_ua/certificates.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

/// The certificate of the link, its login, and the certificates that it trusts. Used by one thread.
class ClientSecurity {
 public:
  explicit ClientSecurity(const SecuritySettings& settings) : settings_(settings) {}

  /// Reads the files, or makes a certificate for this run; only at the first successful call. Why it failed, and what
  /// to do; empty if it did not.
  std::string load();
  /// Gives a configuration that has only a logger the certificate, the login and the defaults for all else.
  UA_StatusCode configure(UA_ClientConfig& config) const;
  /// Whether the certificate of a server may be used: it is in the folder `trust`, or without one the first of this
  /// run. Why it may not, and what to do; empty if it may. After load().
  std::string check(const UA_ByteString& certificate);
  /// What was checked by the latest check(), for the user.
  const std::string& note() const noexcept { return note_; }
  /// The fingerprint of the link's own certificate. After load(), with security.
  std::string own_fingerprint() const;

 private:
  std::string fingerprint(const UA_ByteString* certificate) const;

  const SecuritySettings settings_;
  std::optional<OwnCertificate> own_;
  std::string password_;
  std::optional<TrustedCertificates> trusted_;  ///< nothing: the settings have no folder
  std::string accepted_;                        ///< DER of the server's certificate, from its first use on
  std::string note_;
};

}  // namespace symplant::link::opc_ua
