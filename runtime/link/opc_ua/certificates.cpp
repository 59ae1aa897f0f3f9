// Certificates, keys and passwords of the links of OPC UA.
#include "symplant/link/opc_ua/certificates.hpp"

#include <open62541/plugin/create_certificate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "symplant/link/opc_ua/address.hpp"

namespace symplant::link::opc_ua {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPemBegin = "-----BEGIN CERTIFICATE-----";
constexpr std::string_view kPemEnd = "-----END CERTIFICATE-----";
constexpr std::size_t kThumbprintBytes = 20;

std::optional<std::string> content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || content.empty()) return std::nullopt;
  return content;
}

LinkError unreadable(const char* setting, const std::string& file) {
  return usage_error("`" + std::string(setting) + "=" + file + "`: the file is empty, or cannot be read");
}

std::variant<OwnedBytes, LinkError> bytes_of(const char* setting, const std::string& file) {
  const auto content = content_of(file);
  if (!content) return unreadable(setting, file);
  OwnedBytes bytes;
  const UA_String view = view_of(*content);
  UA_ByteString_copy(&view, bytes.get());
  return bytes;
}

/// The outer element of DER without what follows it; empty if the content is not one.
std::string_view first_element(std::string_view content) {
  constexpr unsigned char kSequence = 0x30;
  constexpr unsigned char kTwoBytes = 0x82;  // a certificate is longer than one byte says, and shorter than 64 KB
  constexpr std::size_t kHeader = 4;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(content[i]); };
  if (content.size() < kHeader || byte(0) != kSequence || byte(1) != kTwoBytes) return {};
  const std::size_t length = kHeader + (std::size_t{byte(2)} << 8 | byte(3));
  return length <= content.size() ? content.substr(0, length) : std::string_view();
}

/// One certificate of DER, or all of PEM; empty if one of them is not valid.
std::vector<std::string> ders_of(std::string_view content) {
  std::size_t begin = content.find(kPemBegin);
  if (begin == content.npos) {
    const std::string_view der = first_element(content);
    return der.empty() ? std::vector<std::string>() : std::vector{std::string(der)};
  }
  std::vector<std::string> ders;
  for (; begin != content.npos; begin = content.find(kPemBegin, begin)) {
    begin += kPemBegin.size();
    const std::size_t end = content.find(kPemEnd, begin);
    if (end == content.npos) return {};
    std::string base64(content.substr(begin, end - begin));
    std::erase_if(base64, [](char c) { return c == '\n' || c == '\r' || c == ' '; });
    OwnedBytes bytes;
    const UA_String view = view_of(base64);
    if (UA_ByteString_fromBase64(bytes.get(), &view) != UA_STATUSCODE_GOOD) return {};
    const std::string_view der = first_element(text_of(*bytes));
    if (der.empty()) return {};
    ders.emplace_back(der);
  }
  return ders;
}

std::variant<OwnCertificate, LinkError> make_certificate(const std::string& name, const std::string& application_uri) {
  std::string common_name = "CN=" + name;  // a comma or `=` would begin another part of the subject
  std::replace_if(
      common_name.begin() + 3, common_name.end(), [](char c) { return c == ',' || c == '=' || c == '+'; }, '-');
  const std::string uri = "URI:" + application_uri;
  const std::array subject = {view_of("O=symplant"), view_of(common_name)};
  const std::array alternatives = {view_of("DNS:localhost"), view_of(uri)};
  std::uint16_t bits = 2048;
  UA_KeyValuePair size;
  size.key = UA_QUALIFIEDNAME(0, const_cast<char*>("key-size-bits"));
  UA_Variant_setScalar(&size.value, &bits, &UA_TYPES[UA_TYPES_UINT16]);
  UA_KeyValueMap options{1, &size};
  OwnCertificate own;
  own.made = true;
  const UA_StatusCode status =
      UA_CreateCertificate(silent(), subject.data(), subject.size(), alternatives.data(), alternatives.size(),
                           UA_CERTIFICATEFORMAT_DER, &options, own.key.get(), own.certificate.get());
  if (status == UA_STATUSCODE_GOOD) return own;
  return LinkError{LinkError::Kind::environment,
                   "cannot make a certificate (" + status_name(status) + "): give `certificate=FILE&key=FILE`"};
}

/// Whether a signature by the policy's private key is valid by its local certificate.
bool are_pair(const UA_SecurityPolicy& policy) {
  void* channel = nullptr;  // to itself: the certificate of the peer is its own
  if (policy.channelModule.newContext(&policy, &policy.localCertificate, &channel) != UA_STATUSCODE_GOOD) return false;
  const UA_SecurityPolicySignatureAlgorithm& algorithm = policy.asymmetricModule.cryptoModule.signatureAlgorithm;
  constexpr std::string_view kSigned = "a certificate and its key";
  const UA_ByteString message = view_of(kSigned);
  OwnedBytes signature;
  UA_StatusCode status = UA_ByteString_allocBuffer(signature.get(), algorithm.getLocalSignatureSize(channel));
  if (status == UA_STATUSCODE_GOOD) status = algorithm.sign(channel, &message, signature.get());
  if (status == UA_STATUSCODE_GOOD) status = algorithm.verify(channel, &message, signature.get());
  policy.channelModule.deleteContext(channel);
  return status == UA_STATUSCODE_GOOD;
}

}  // namespace

std::variant<OwnCertificate, LinkError> own_certificate(const SecuritySettings& settings, const std::string& name,
                                                        const std::string& application_uri) {
  if (settings.certificate.empty()) return make_certificate(name, application_uri);
  auto certificate = bytes_of("certificate", settings.certificate);
  if (auto* error = std::get_if<LinkError>(&certificate)) return std::move(*error);
  auto key = bytes_of("key", settings.key);
  if (auto* error = std::get_if<LinkError>(&key)) return std::move(*error);
  OwnCertificate own;
  own.certificate = std::move(std::get<OwnedBytes>(certificate));
  own.key = std::move(std::get<OwnedBytes>(key));
  return own;
}

std::variant<std::string, LinkError> read_password(const std::string& file) {
  const auto content = content_of(file);
  if (!content) return unreadable("password-file", file);
  std::string line = content->substr(0, content->find('\n'));
  if (line.ends_with('\r')) line.pop_back();
  if (line.empty()) return usage_error("`password-file=" + file + "`: the first line, the password, is empty");
  return line;
}

std::string thumbprint(const UA_SecurityPolicy& policy, const UA_ByteString& certificate) {
  std::array<std::uint8_t, kThumbprintBytes> bytes{};
  UA_ByteString view{bytes.size(), bytes.data()};
  const UA_StatusCode status = policy.asymmetricModule.makeCertificateThumbprint(&policy, &certificate, &view);
  if (status != UA_STATUSCODE_GOOD) return {};
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) text.append(1, kDigits[byte >> 4]).append(1, kDigits[byte & 15]);
  return text;
}

std::optional<LinkError> pair_fault(const SecuritySettings& settings, const UA_SecurityPolicy& policy) {
  if (are_pair(policy)) return std::nullopt;
  return usage_error("`certificate=" + settings.certificate + "&key=" + settings.key +
                     "`: the private key is not that of the certificate");
}

std::variant<TrustedCertificates, LinkError> TrustedCertificates::read(const std::string& folder) {
  constexpr std::array<std::string_view, 4> kEndings = {".der", ".crt", ".cer", ".pem"};
  TrustedCertificates trusted;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) continue;
    const auto content = content_of(entry.path());
    std::vector<std::string> ders;
    if (content) ders = ders_of(*content);
    if (ders.empty())
      return usage_error("`" + entry.path().string() + "` in `trust` is not a certificate in DER or PEM");
    for (std::string& der : ders) trusted.certificates_.insert(std::move(der));
  }
  if (error) return usage_error("`trust=" + folder + "`: " + error.message());
  if (trusted.certificates_.empty()) {
    return usage_error("`trust=" + folder +
                       "`: no file *.der, *.crt, *.cer or *.pem in the folder: put the certificates "
                       "of trusted peers there");
  }
  return trusted;
}

}  // namespace symplant::link::opc_ua
