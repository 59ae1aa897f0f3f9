// The files of a link `opc-ua` with security: what is wrong with them is known before the link connects.
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/link/opc_ua/certificates.hpp"
#include "symplant/link/opc_ua/client_link_parts.hpp"
#include "symplant/link/opc_ua/client_security.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using namespace symplant::link;
using Catch::Matchers::ContainsSubstring;
using opc_ua::OwnCertificate;
using opc_ua::text_of;
using opc_ua::TrustedCertificates;

namespace {

/// Why no link is made with these settings of security; it is an error of kind usage.
std::string refusal(const std::string& settings) {
  test::SymbolList list;
  list.add("RUN", test::SymbolList::kOut, 0U);
  const auto tables = list.tables();
  const std::string rest = "//127.0.0.1:4840?nodes=ns=1;s={symbol}&security=encrypt" + settings;
  const auto parts = opc_ua::client_link_parts(rest, {.url = "opc-ua:" + rest, .controller = 0}, tables);
  const auto* const error = std::get_if<LinkError>(&parts);
  if (error == nullptr) return {};
  CHECK(error->kind == LinkError::Kind::usage);
  return error->message;
}

OwnCertificate made() { return std::get<OwnCertificate>(opc_ua::own_certificate({}, "symplant", "urn:test")); }

std::string pem_of(const OwnCertificate& own) {
  opc_ua::OwnedString base64;
  UA_ByteString_toBase64(own.certificate.get(), base64.get());
  return "-----BEGIN CERTIFICATE-----\n" + std::string(text_of(*base64)) + "\n-----END CERTIFICATE-----\n";
}

}  // namespace

TEST_CASE("A file of the security settings that cannot be used is an error before the link connects") {
  const test::TemporaryFolder folder;
  const OwnCertificate own = made();
  folder.write("own.der", std::string(text_of(*own.certificate)));
  folder.write("own.key", std::string(text_of(*own.key)));
  folder.write("words", "no certificate and no key");
  const auto pair = [&](const char* certificate, const char* key) {
    return "&certificate=" + (folder / certificate) + "&key=" + (folder / key);
  };
  CHECK(refusal(pair("own.der", "own.key")).empty());
  CHECK_THAT(refusal("&user=a&password-file=" + (folder / "missing")), ContainsSubstring("`password-file="));
  CHECK_THAT(refusal(pair("missing", "own.key")), ContainsSubstring("`certificate="));
  CHECK_THAT(refusal(pair("own.der", "missing")), ContainsSubstring("`key="));
  CHECK_THAT(refusal(pair("own.der", "words")), ContainsSubstring("does not accept"));
  CHECK_THAT(refusal(pair("words", "own.key")), ContainsSubstring("does not accept"));
  folder.write("other.key", std::string(text_of(*made().key)));
  CHECK_THAT(refusal(pair("own.der", "other.key")),
             ContainsSubstring("the private key is not that of the certificate"));
  CHECK_THAT(refusal("&trust=" + (folder / "missing")), ContainsSubstring("`trust="));
}

TEST_CASE("All certificates of a PEM are trusted, and DER may have bytes behind it") {
  const test::TemporaryFolder folder;
  const OwnCertificate one = made();
  const OwnCertificate two = made();
  const OwnCertificate three = made();
  folder.write("trust/both.pem", "of two peers\n" + pem_of(one) + pem_of(two));
  folder.write("trust/three.der", std::string(text_of(*three.certificate)) + "\n");
  const auto read = TrustedCertificates::read(folder / "trust");
  const auto& trusted = std::get<TrustedCertificates>(read);
  CHECK(trusted.has(*one.certificate));
  CHECK(trusted.has(*two.certificate));
  CHECK(trusted.has(*three.certificate));
  CHECK(!trusted.has(*made().certificate));
  folder.write("trust/cut.pem", pem_of(one) + pem_of(two).substr(0, 100));
  CHECK_THAT(std::get<LinkError>(TrustedCertificates::read(folder / "trust")).message, ContainsSubstring("cut.pem"));
}

TEST_CASE("Without trust, the certificate of the first session is the one of the run") {
  opc_ua::SecuritySettings settings;
  settings.security = opc_ua::Security::encrypt;
  auto loaded = opc_ua::ClientSecurity::load(settings);
  auto& security = std::get<opc_ua::ClientSecurity>(loaded);
  const OwnCertificate one = made();
  const OwnCertificate other = made();
  CHECK(security.check(*one.certificate).empty());  // the session was not begun
  CHECK(security.check(*other.certificate).empty());
  security.accept(*other.certificate);
  CHECK_THAT(security.check(*one.certificate), ContainsSubstring("another certificate"));
  CHECK(security.check(*other.certificate).empty());
}
