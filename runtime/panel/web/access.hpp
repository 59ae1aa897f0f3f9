// Decides the role of a request: by tokens, and by the page of the browser that made it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "symplant/panel/role.hpp"

namespace symplant::panel {

/// The headers of a request that decide about access. Empty: not sent.
struct Claim {
  std::string_view host;
  std::string_view origin;
  std::string_view authorization;
};

/// The tokens by Role. Empty: no client has this role by a token.
using Tokens = std::array<std::string, kRoles>;

/// Immutable; any thread may use it.
class Access {
 public:
  /// `host`: as given to --panel; `port`: the real one. The trainer has a token.
  Access(std::string host, std::uint16_t port, Tokens tokens);

  /// Whether `Host` is an address of the panel and `Origin`, if there is one, the panel itself. This refuses other
  /// pages, and names that an attacker has pointed at this machine (DNS rebinding).
  bool is_own(const Claim& claim) const;
  /// The role of its token; nothing if it has no valid one. In constant time.
  std::optional<Role> role_by_token(const Claim& claim) const;
  /// The same; without a valid token a viewer, unless the panel can be reached from other machines.
  std::optional<Role> role(const Claim& claim) const;

  bool has_role(Role role) const { return !token(role).empty(); }
  /// The address without token: `http://127.0.0.1:8137/`.
  std::string url() const;
  /// The address with the token of a role, as a link for a browser.
  std::string link(Role role) const { return url() + "#token=" + token(role); }

 private:
  bool is_known_host(std::string_view name) const;
  const std::string& token(Role role) const { return tokens_[static_cast<std::size_t>(role)]; }

  std::string host_;
  std::uint16_t port_;
  Tokens tokens_;
  std::string machine_;  ///< the name of this machine
  bool is_loopback_;
};

/// 32 hexadecimal digits from the system's source of randomness.
std::string random_token();

inline constexpr int kLongestToken = 256;

/// Whether a text is a token: 32 to 256 letters, digits, `-` or `_`.
bool is_token(std::string_view text);

}  // namespace symplant::panel
