// Certificates, keys and passwords of the links of OPC UA.
#pragma once

#include <open62541/plugin/securitypolicy.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

/// The certificate of a link and its private key.
struct OwnCertificate {
  OwnedBytes certificate;  ///< DER or PEM
  OwnedBytes key;          ///< DER or PEM
  bool made = false;       ///< for this run, since the settings name no files
};

/// Reads the files of the settings, or makes a self-signed certificate for `application_uri`, which takes up to a
/// second. `name` is its common name. A file that cannot be read is an error of kind usage.
std::variant<OwnCertificate, LinkError> own_certificate(const SecuritySettings& settings, const std::string& name,
                                                        const std::string& application_uri);

/// The first line of the file, which must not be empty. Errors are of kind usage.
std::variant<std::string, LinkError> read_password(const std::string& file);

/// The SHA-1 thumbprint of a certificate in DER by which programs of OPC UA show it, in upper-case hexadecimal; empty
/// if the policy cannot make it. `policy` is any but None.
std::string thumbprint(const UA_SecurityPolicy& policy, const UA_ByteString& certificate);

/// An error of kind usage if the private key of the policy is not that of its local certificate, which nothing else
/// checks: the policy signs some bytes, and verifies them by the certificate. `settings` name the files. `policy` is
/// any but None. Takes some milliseconds.
std::optional<LinkError> pair_fault(const SecuritySettings& settings, const UA_SecurityPolicy& policy);

/// The certificates of a folder. Immutable; for any thread.
class TrustedCertificates {
 public:
  /// The files `*.der`, `*.crt`, `*.cer` and `*.pem` of a folder. One that cannot be read, and a folder without any,
  /// are errors of kind usage.
  static std::variant<TrustedCertificates, LinkError> read(const std::string& folder);

  /// Whether the folder has exactly this certificate, in DER. Neither issuers nor dates count. O(log certificates).
  bool has(const UA_ByteString& certificate) const { return certificates_.contains(text_of(certificate)); }

 private:
  std::set<std::string, std::less<>> certificates_;  ///< in DER
};

}  // namespace symplant::link::opc_ua
