// Decides whether a request may look and whether it may act: by tokens, and by the page of the browser that made it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symplant::panel {

/// The headers of a request that decide about access. Empty: not sent.
struct Claim {
  std::string_view host;
  std::string_view origin;
  std::string_view authorization;
};

/// Immutable; any thread may use it.
class Access {
 public:
  /// `host`: as given to --panel; `port`: the real one. `token`: 32 hexadecimal digits.
  Access(std::string host, std::uint16_t port, std::string token);

  /// Whether `Host` is an address of the panel and `Origin`, if there is one, the panel itself. This refuses other
  /// pages, and names that an attacker has pointed at this machine (DNS rebinding).
  bool is_own(const Claim& claim) const;
  /// Whether the token is right; in constant time.
  bool has_token(const Claim& claim) const;
  /// Whether looking needs the token, too: if the panel can be reached from other machines.
  bool look_needs_token() const { return !is_loopback_; }

  const std::string& token() const { return token_; }
  /// The address without token: `http://127.0.0.1:8137/`.
  std::string url() const;

 private:
  bool is_known_host(std::string_view name) const;

  std::string host_;
  std::uint16_t port_;
  std::string token_;
  std::string machine_;  ///< the name of this machine
  bool is_loopback_;
};

/// 32 hexadecimal digits from the system's source of randomness.
std::string random_token();

inline constexpr int kLongestToken = 256;

/// Whether a text is a token: 32 to 256 letters, digits, `-` or `_`.
bool is_token(std::string_view text);

}  // namespace symplant::panel
