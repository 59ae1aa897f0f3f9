// The URI of the application in a certificate.
#include "symplant/link/opc_ua/application_uri.hpp"

#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace symplant::link::opc_ua {

namespace {

/// Takes the length of an element of DER whose tag was taken; nothing if the bytes end before the element.
std::optional<std::size_t> take_length(std::string_view& bytes) {
  constexpr std::size_t kLong = 0x80;
  if (bytes.empty()) return std::nullopt;
  std::size_t length = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  if (length >= kLong) {
    const std::size_t digits = length - kLong;
    if (digits == 0 || digits > 2 || digits > bytes.size()) return std::nullopt;
    length = 0;
    for (std::size_t i = 0; i < digits; ++i) length = length << 8 | static_cast<unsigned char>(bytes[i]);
    bytes.remove_prefix(digits);
  }
  return length <= bytes.size() ? std::optional(length) : std::nullopt;
}

/// Takes one element of DER: its tag and its content. All bytes are taken if it is not complete.
std::pair<unsigned, std::string_view> take_element(std::string_view& bytes) {
  std::string_view rest = std::exchange(bytes, {});
  if (rest.empty()) return {};
  const unsigned tag = static_cast<unsigned char>(rest.front());
  rest.remove_prefix(1);
  const auto length = take_length(rest);
  if (!length) return {};
  bytes = rest.substr(*length);
  return {tag, rest.substr(0, *length)};
}

}  // namespace

std::string application_uri_of(std::string_view certificate) {
  constexpr std::string_view kAlternativeNames("\x06\x03\x55\x1D\x11", 5);  // the object identifier 2.5.29.17
  constexpr unsigned kBoolean = 0x01;
  constexpr unsigned kOctets = 0x04;
  constexpr unsigned kSequence = 0x30;
  constexpr unsigned kUri = 0x86;
  const std::size_t at = certificate.find(kAlternativeNames);
  if (at == certificate.npos) return {};
  std::string_view rest = certificate.substr(at + kAlternativeNames.size());
  auto [tag, content] = take_element(rest);
  if (tag == kBoolean) std::tie(tag, content) = take_element(rest);  // the extension is critical
  if (tag != kOctets) return {};
  auto [inner, names] = take_element(content);
  if (inner != kSequence) return {};
  while (!names.empty()) {
    const auto [kind, name] = take_element(names);
    if (kind == kUri) return std::string(name);
  }
  return {};
}

}  // namespace symplant::link::opc_ua
