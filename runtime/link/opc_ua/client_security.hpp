// What a link `opc-ua` needs to connect with security; only for .cpp files of this folder.
#pragma once

#include <open62541/client.h>

#include <optional>
#include <string>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/opc_ua/certificates.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

/// The certificate of the link, its login, and the certificates that it trusts. Used by one thread.
class ClientSecurity {
 public:
  /// Reads the files, or makes a certificate for this run, which takes up to a second. A file that cannot be read or
  /// used is an error of kind usage.
  static std::variant<ClientSecurity, LinkError> load(const SecuritySettings& settings);

  /// Gives a configuration that has only a logger the certificate, the login and the defaults for all else.
  UA_StatusCode configure(UA_ClientConfig& config) const;
  /// Whether the certificate of a server may be used: it is in the folder `trust`, or without one no other was
  /// accepted. Why it may not, and what to do; empty if it may.
  std::string check(const UA_ByteString& certificate);
  /// The first connection with this certificate works: without `trust`, only it may be used from now on.
  void accept(const UA_ByteString& certificate) {
    if (accepted_.empty()) accepted_ = text_of(certificate);
  }
  /// What was checked by the latest check(), for the user.
  const std::string& note() const noexcept { return note_; }
  /// The fingerprint of the link's own certificate; with security.
  std::string own_fingerprint() const;

 private:
  explicit ClientSecurity(const SecuritySettings& settings) : settings_(settings) {}
  std::optional<LinkError> read_files();
  std::optional<LinkError> try_out() const;
  std::string fingerprint(const UA_ByteString* certificate) const;

  SecuritySettings settings_;
  std::optional<OwnCertificate> own_;
  std::string password_;
  std::optional<TrustedCertificates> trusted_;  ///< nothing: the settings have no folder
  std::string accepted_;                        ///< DER of the server's certificate, from its first session on
  std::string note_;
};

}  // namespace symplant::link::opc_ua
