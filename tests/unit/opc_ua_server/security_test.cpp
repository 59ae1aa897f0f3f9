// Users, certificates and endpoints of the OPC UA server.
#include <open62541/plugin/pki_default.h>

#include "support/temporary_folder.hpp"
#include "symplant/link/opc_ua/certificates.hpp"
#include "unit/opc_ua_server/served_plant.hpp"

using namespace symplant;
using link::opc_ua::own_certificate;
using link::opc_ua::OwnCertificate;
using link::opc_ua::read_password;
using link::opc_ua::text_of;
using link::opc_ua::TrustedCertificates;
using test::ServedPlant;

namespace {

const test::DescribedPlant& small() {
  static const test::DescribedPlant described(
      {{"L_S_C_O_A", "", "BOOL", "FALSE", "%QX0"}, {"L_S_C_I_A", "", "BOOL", "FALSE", "%IX0"}}, R"("name": "small")");
  return described;
}

const OwnCertificate& client_certificate() {
  static const OwnCertificate made = [] {
    auto result = own_certificate({}, "client", "urn:test:client");
    return std::move(std::get<OwnCertificate>(result));
  }();
  return made;
}

/// A client with Basic256Sha256 in this mode, which accepts every server.
UA_Client* secure_client(UA_MessageSecurityMode mode) {
  UA_ClientConfig config{};
  config.logging = link::opc_ua::silent();
  UA_ClientConfig_setDefaultEncryption(&config, *client_certificate().certificate, *client_certificate().key, nullptr,
                                       0, nullptr, 0);
  UA_String_clear(&config.clientDescription.applicationUri);
  config.clientDescription.applicationUri = UA_STRING_ALLOC(const_cast<char*>("urn:test:client"));
  UA_CertificateVerification_AcceptAll(&config.certificateVerification);
  config.securityMode = mode;
  return UA_Client_newWithConfig(&config);
}

/// The status of a connection of the client, which it deletes; anonymous without `user`.
UA_StatusCode connect(UA_Client* client, const std::string& endpoint, const char* user, const char* password) {
  const UA_StatusCode status = user == nullptr ? UA_Client_connect(client, endpoint.c_str())
                                               : UA_Client_connectUsername(client, endpoint.c_str(), user, password);
  UA_Client_delete(client);
  return status;
}

UA_StatusCode connect(const std::string& endpoint, UA_MessageSecurityMode mode, const char* user,
                      const char* password) {
  return connect(secure_client(mode), endpoint, user, password);
}

/// The same, by an endpoint that the server does not offer: its first one in another mode, or for anonymous users.
UA_StatusCode connect_anyway(const std::string& endpoint, UA_MessageSecurityMode mode, const char* user,
                             const char* password) {
  UA_Client* const client = secure_client(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT);
  std::size_t count = 0;
  UA_EndpointDescription* offered = nullptr;
  REQUIRE(UA_Client_getEndpoints(client, endpoint.c_str(), &count, &offered) == UA_STATUSCODE_GOOD);
  REQUIRE(count != 0);
  REQUIRE(offered->userIdentityTokensSize == 1);
  UA_EndpointDescription& wanted = UA_Client_getConfig(client)->endpoint;
  UA_EndpointDescription_copy(offered, &wanted);
  UA_Array_delete(offered, count, &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]);
  wanted.securityMode = mode;
  if (mode == UA_MESSAGESECURITYMODE_NONE) {
    UA_String_clear(&wanted.securityPolicyUri);
    wanted.securityPolicyUri = UA_STRING_ALLOC(const_cast<char*>("http://opcfoundation.org/UA/SecurityPolicy#None"));
  }
  if (user == nullptr) wanted.userIdentityTokens->tokenType = UA_USERTOKENTYPE_ANONYMOUS;
  return connect(client, endpoint, user, password);
}

}  // namespace

TEST_CASE("With encryption only the user with the password gets a session, over an encrypted channel") {
  const test::TemporaryFolder folder;
  folder.write("password", "secret\nsecond line\n");
  ServedPlant served(small().rows, "?security=encrypt&user=scada&password-file=" + (folder / "password"));
  const std::string endpoint = served.endpoint();
  CHECK(connect(endpoint, UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, "scada", "secret") == UA_STATUSCODE_GOOD);
  CHECK(connect(endpoint, UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, "scada", "wrong") ==
        UA_STATUSCODE_BADUSERACCESSDENIED);
  CHECK(connect_anyway(endpoint, UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, nullptr, nullptr) ==
        UA_STATUSCODE_BADIDENTITYTOKENINVALID);
  CHECK(connect_anyway(endpoint, UA_MESSAGESECURITYMODE_SIGN, "scada", "secret") ==
        UA_STATUSCODE_BADIDENTITYTOKENINVALID);  // no endpoint of this mode has users
  CHECK(connect_anyway(endpoint, UA_MESSAGESECURITYMODE_NONE, "scada", "secret") ==
        UA_STATUSCODE_BADSECURITYPOLICYREJECTED);
  const auto messages = served.link().take_messages();
  REQUIRE(messages.size() == 3);
  CHECK(messages[0].find("made a certificate for this run, with the thumbprint ") != std::string::npos);
  CHECK(messages[1].find("every client is accepted") != std::string::npos);
  CHECK(messages[2].find("a client with the user name `scada` and a wrong password") != std::string::npos);
}

TEST_CASE("With signing, signed and encrypted channels are possible") {
  const test::TemporaryFolder folder;
  folder.write("password", "secret");
  ServedPlant served(small().rows, "?security=sign&user=scada&password-file=" + (folder / "password"));
  CHECK(connect(served.endpoint(), UA_MESSAGESECURITYMODE_SIGN, "scada", "secret") == UA_STATUSCODE_GOOD);
  CHECK(connect_anyway(served.endpoint(), UA_MESSAGESECURITYMODE_SIGN, "scada", "secret") == UA_STATUSCODE_GOOD);
  CHECK(connect(served.endpoint(), UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, "scada", "secret") == UA_STATUSCODE_GOOD);
}

TEST_CASE("With a folder of trusted certificates, clients with another one are refused") {
  const test::TemporaryFolder folder;
  folder.write("password", "secret");
  const auto other = own_certificate({}, "other", "urn:test:other");
  folder.write("trusted/other.der", text_of(*std::get<OwnCertificate>(other).certificate));
  const std::string settings =
      "?security=encrypt&user=scada&password-file=" + (folder / "password") + "&trust=" + (folder / "trusted");
  {
    ServedPlant served(small().rows, settings);
    CHECK(connect(served.endpoint(), UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, "scada", "secret") != UA_STATUSCODE_GOOD);
    const auto messages = served.link().take_messages();
    REQUIRE(messages.size() == 2);
    CHECK(messages[1].find("is not in the folder `trust`") != std::string::npos);
  }
  folder.write("trusted/client.der", text_of(*client_certificate().certificate));
  ServedPlant served(small().rows, settings);
  CHECK(connect(served.endpoint(), UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, "scada", "secret") == UA_STATUSCODE_GOOD);
}

TEST_CASE("Files that are missing or wrong are errors of the settings") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path();
  CHECK(std::holds_alternative<link::LinkError>(read_password(path + "/none")));
  folder.write("empty", "\nsecond");
  CHECK(std::holds_alternative<link::LinkError>(read_password(path + "/empty")));
  CHECK(std::holds_alternative<link::LinkError>(TrustedCertificates::read(path + "/none")));
  CHECK(std::holds_alternative<link::LinkError>(TrustedCertificates::read(path)));
  folder.write("wrong.der", "not a certificate");
  CHECK(std::holds_alternative<link::LinkError>(TrustedCertificates::read(path)));
  folder.write("password", "secret");
  const auto result = link::open_link({"opc-ua-server://127.0.0.1:0?security=encrypt&user=a&password-file=" + path +
                                       "/password&certificate=" + path + "/wrong.der&key=" + path + "/wrong.der"},
                                      small().rows);
  REQUIRE(std::holds_alternative<link::LinkError>(result));
  CHECK(std::get<link::LinkError>(result).kind == link::LinkError::Kind::usage);
}

TEST_CASE("A trusted certificate may be in PEM") {
  const test::TemporaryFolder folder;
  link::opc_ua::OwnedString base64;
  UA_ByteString_toBase64(client_certificate().certificate.get(), base64.get());
  folder.write("client.pem",
               "-----BEGIN CERTIFICATE-----\n" + std::string(text_of(*base64)) + "\n-----END CERTIFICATE-----\n");
  const auto trusted = TrustedCertificates::read(folder.path());
  REQUIRE(std::holds_alternative<TrustedCertificates>(trusted));
  CHECK(std::get<TrustedCertificates>(trusted).has(*client_certificate().certificate));
}

TEST_CASE("A key of another certificate, and a certificate of another application, are errors of the settings") {
  const test::TemporaryFolder folder;
  folder.write("password", "secret");
  const auto write = [&](const char* name, const OwnCertificate& own) {
    folder.write(std::string(name) + ".der", text_of(*own.certificate));
    folder.write(std::string(name) + ".key", text_of(*own.key));
  };
  const auto made = own_certificate({}, "server", "urn:symplant:server:small");
  write("server", std::get<OwnCertificate>(made));
  write("client", client_certificate());
  const auto fault = [&](const std::string& certificate, const std::string& key) {
    const auto result =
        link::open_link({"opc-ua-server://127.0.0.1:0?security=encrypt&user=a&password-file=" + (folder / "password") +
                         "&certificate=" + (folder / certificate) + "&key=" + (folder / key)},
                        small().rows);
    const auto* const error = std::get_if<link::LinkError>(&result);
    if (error == nullptr) return std::string();
    CHECK(error->kind == link::LinkError::Kind::usage);
    return error->message;
  };
  CHECK(fault("server.der", "server.key").empty());
  CHECK(fault("server.der", "client.key").find("the private key is not that of the certificate") != std::string::npos);
  const std::string other = fault("client.der", "client.key");
  CHECK(other.find("its application URI is `urn:test:client`") != std::string::npos);
  CHECK(other.find("that of the server is `urn:symplant:server:small`") != std::string::npos);
}
