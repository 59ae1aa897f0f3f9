// The settings of security that both links of OPC UA have, and their keys in a URL.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "symplant/link/url_values.hpp"

namespace symplant::link::opc_ua {

enum class Security : std::uint8_t {
  none,     ///< policy None
  sign,     ///< Basic256Sha256, messages are signed
  encrypt,  ///< Basic256Sha256, messages are signed and encrypted
};

/// Files are not read before the link is opened.
struct SecuritySettings {
  Security security = Security::none;
  std::string user;           ///< empty: anonymous
  std::string password_file;  ///< its first line is the password
  std::string certificate;    ///< file of the link's certificate, DER or PEM; empty: made for this run
  std::string key;            ///< file of its private key, DER or PEM
  std::string trust;          ///< folder with certificates of trusted peers; empty: any certificate is accepted
};

Problem read_security(std::string_view text, SecuritySettings& settings);

/// What is wrong with settings that are valid one by one; empty if nothing is. Without security no password is sent.
Problem contradiction(const SecuritySettings& settings);

/// The keys of `Settings`, which has the SecuritySettings as its member `security`.
template <class Settings>
constexpr std::array<UrlKey<Settings>, 6> security_keys() {
  using Key = UrlKey<Settings>;
  return {
      Key{"security", [](std::string_view text, Settings& s) { return read_security(text, s.security); }},
      Key{"user", [](std::string_view text, Settings& s) { return s.security.user = text, Problem(); }},
      Key{"password-file",
          [](std::string_view text, Settings& s) { return s.security.password_file = text, Problem(); }},
      Key{"certificate", [](std::string_view text, Settings& s) { return s.security.certificate = text, Problem(); }},
      Key{"key", [](std::string_view text, Settings& s) { return s.security.key = text, Problem(); }},
      Key{"trust", [](std::string_view text, Settings& s) { return s.security.trust = text, Problem(); }}};
}

/// One table of keys from two. O(keys).
template <class Key, std::size_t A, std::size_t B>
constexpr std::array<Key, A + B> joined(const std::array<Key, A>& first, const std::array<Key, B>& second) {
  std::array<Key, A + B> all{};
  for (std::size_t i = 0; i < A; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < B; ++i) all[A + i] = second[i];
  return all;
}

}  // namespace symplant::link::opc_ua
