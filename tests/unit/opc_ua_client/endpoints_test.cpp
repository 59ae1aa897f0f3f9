// The endpoint of a server that a link `opc-ua` chooses.
#include "symplant/link/opc_ua/endpoints.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace symplant::link::opc_ua;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string kPolicy = "http://opcfoundation.org/UA/SecurityPolicy#";
const std::string kNone = kPolicy + "None";
const std::string kBasic = kPolicy + "Basic256Sha256";
const std::string kAes = kPolicy + "Aes256_Sha256_RsaPss";
const std::string kOld = kPolicy + "Basic128Rsa15";

UA_UserTokenPolicy token(UA_UserTokenType type, std::string_view policy = {}) {
  UA_UserTokenPolicy result{};
  result.tokenType = type;
  result.securityPolicyUri = view_of(policy);
  return result;
}

/// The endpoints of a server; they live as long as it.
class Offer {
 public:
  Offer& add(UA_MessageSecurityMode mode, std::string_view policy, std::vector<UA_UserTokenPolicy> tokens,
             UA_Byte level) {
    tokens_.push_back(std::move(tokens));
    UA_EndpointDescription endpoint{};
    endpoint.securityMode = mode;
    endpoint.securityPolicyUri = view_of(policy);
    endpoint.userIdentityTokens = tokens_.back().data();
    endpoint.userIdentityTokensSize = tokens_.back().size();
    endpoint.securityLevel = level;
    endpoints_.push_back(endpoint);
    return *this;
  }
  /// "level of the endpoint", or the problem.
  std::string choose(const SecuritySettings& settings) const {
    std::string problem;
    const auto chosen = choose_endpoint(endpoints_, settings, problem);
    return chosen ? std::to_string(chosen->endpoint->securityLevel) : problem;
  }

 private:
  std::vector<std::vector<UA_UserTokenPolicy>> tokens_;
  std::vector<UA_EndpointDescription> endpoints_;
};

SecuritySettings settings_with(Security security, const std::string& user = {}) {
  SecuritySettings settings;
  settings.security = security;
  settings.user = user;
  return settings;
}

const SecuritySettings kPlain = settings_with(Security::none);
const SecuritySettings kSign = settings_with(Security::sign);
const SecuritySettings kEncrypt = settings_with(Security::encrypt);
const SecuritySettings kUser = settings_with(Security::encrypt, "operator");
const SecuritySettings kSignedUser = settings_with(Security::sign, "operator");
constexpr auto kAnonymous = UA_USERTOKENTYPE_ANONYMOUS;
constexpr auto kNamed = UA_USERTOKENTYPE_USERNAME;

}  // namespace

TEST_CASE("The endpoint of the highest level with the wanted security is chosen") {
  Offer offer;
  offer.add(UA_MESSAGESECURITYMODE_NONE, kNone, {token(kAnonymous)}, 1)
      .add(UA_MESSAGESECURITYMODE_SIGN, kBasic, {token(kAnonymous)}, 10)
      .add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kBasic, {token(kAnonymous)}, 20)
      .add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kAes, {token(kAnonymous)}, 30)
      .add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kOld, {token(kAnonymous)}, 40);
  CHECK(offer.choose(kPlain) == "1");
  CHECK(offer.choose(kSign) == "30");
  CHECK(offer.choose(kEncrypt) == "30");
}

TEST_CASE("What a server offers is listed if it is not what the link wants") {
  Offer offer;
  CHECK_THAT(offer.choose(kPlain), ContainsSubstring("it offers: nothing"));
  offer.add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kOld, {token(kAnonymous)}, 1);
  CHECK_THAT(offer.choose(kEncrypt),
             ContainsSubstring("does not offer `security=encrypt`; it offers: encrypt with Basic128Rsa15"));
  CHECK_THAT(offer.choose(kPlain), ContainsSubstring("does not offer `security=none`"));
  const std::string strange = kPolicy + "\x1B[2J";
  offer.add(UA_MESSAGESECURITYMODE_SIGN, strange, {token(kAnonymous)}, 1);
  CHECK_THAT(offer.choose(kPlain), ContainsSubstring("sign with ?[2J"));  // no control characters
}

TEST_CASE("A login that the server does not have is reported with what to do") {
  Offer named;
  named.add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kBasic, {token(kNamed)}, 1);
  named.add(UA_MESSAGESECURITYMODE_NONE, kNone, {token(kNamed, kBasic)}, 0);
  CHECK(named.choose(kUser) == "1");
  CHECK_THAT(named.choose(kEncrypt), ContainsSubstring("give `user=NAME&password-file=FILE`, or allow"));
  CHECK_THAT(named.choose(kPlain), ContainsSubstring("`user=NAME&password-file=FILE` and `security=encrypt`"));
  Offer anonymous;
  anonymous.add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kBasic, {token(kAnonymous)}, 1);
  CHECK_THAT(anonymous.choose(kUser), ContainsSubstring("leave out `user`"));
}

TEST_CASE("A password is not sent where anyone could read it") {
  Offer offer;
  offer.add(UA_MESSAGESECURITYMODE_SIGN, kBasic, {token(kNamed, kNone)}, 1);
  CHECK_THAT(offer.choose(kSignedUser), ContainsSubstring("encrypted password"));
  offer.add(UA_MESSAGESECURITYMODE_SIGN, kBasic, {token(kNamed)}, 2);
  CHECK(offer.choose(kSignedUser) == "2");
  offer.add(UA_MESSAGESECURITYMODE_SIGNANDENCRYPT, kBasic, {token(kNamed, kNone)}, 3);
  CHECK(offer.choose(kSignedUser) == "3");  // the channel encrypts it
}
