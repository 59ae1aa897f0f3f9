// Decides the role of a request: by tokens, and by the page of the browser that made it.
#include "symplant/panel/web/access.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "symplant/link/net/host_port.hpp"
#include "symplant/link/net/system.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/web/header_text.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kShortestToken = 32;

bool is_ip_address(std::string_view text) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  const std::string name(text);
  return inet_pton(AF_INET, name.c_str(), bytes.data()) == 1 || inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1;
}

bool is_loopback_host(std::string_view host) {
  return equal_ignoring_case(host, "localhost") || host == "::1" || (is_ip_address(host) && host.starts_with("127."));
}

/// A header `Host` as name and port.
struct HostHeader {
  std::string_view name;
  std::string_view port;
};

/// NAME, NAME:PORT, [IPv6] or [IPv6]:PORT; nothing for any other text.
std::optional<HostHeader> split_host(std::string_view header) {
  const bool is_bracketed = header.starts_with('[');
  const std::size_t end = is_bracketed ? header.find(']') : std::min(header.find(':'), header.size());
  if (end == header.npos) return std::nullopt;
  const std::string_view name = is_bracketed ? header.substr(1, end - 1) : header.substr(0, end);
  const std::string_view rest = header.substr(is_bracketed ? end + 1 : end);
  if (is_bracketed && name.find(':') == name.npos) return std::nullopt;
  if (rest.empty()) return HostHeader{name, "80"};
  if (!rest.starts_with(':')) return std::nullopt;
  return HostHeader{name, rest.substr(1)};
}

std::string machine_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

/// In a time that depends on the lengths only.
bool is_same(std::string_view given, std::string_view token) {
  unsigned difference = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const char c = i < given.size() ? given[i] : '\0';
    difference |= static_cast<unsigned>(static_cast<unsigned char>(c) ^ static_cast<unsigned char>(token[i]));
  }
  return difference == 0 && !token.empty();
}

}  // namespace

Access::Access(std::string host, std::uint16_t port, Tokens tokens)
    : host_(std::move(host)),
      port_(port),
      tokens_(std::move(tokens)),
      machine_(machine_name()),
      is_loopback_(is_loopback_host(host_)) {}

bool Access::is_known_host(std::string_view name) const {
  return equal_ignoring_case(name, "localhost") || is_ip_address(name) || equal_ignoring_case(name, host_) ||
         (!machine_.empty() && equal_ignoring_case(name, machine_));
}

bool Access::is_own(const Claim& claim) const {
  const std::optional<HostHeader> host = split_host(claim.host);
  if (!host || !is_known_host(host->name) || host->port != std::to_string(port_)) return false;
  return claim.origin.empty() || equal_ignoring_case(claim.origin, "http://" + std::string(claim.host));
}

std::optional<Role> Access::role_by_token(const Claim& claim) const {
  constexpr std::string_view kScheme = "Bearer ";
  if (!claim.authorization.starts_with(kScheme)) return std::nullopt;
  const std::string_view given = claim.authorization.substr(kScheme.size());
  std::optional<Role> role;
  for (const Role each : {Role::viewer, Role::trainee, Role::trainer}) {
    if (is_same(given, token(each))) role = each;
  }
  return role;
}

std::optional<Role> Access::role(const Claim& claim) const {
  const std::optional<Role> role = role_by_token(claim);
  return role || !is_loopback_ ? role : Role::viewer;
}

std::string Access::url() const {
  const bool everywhere = host_ == "0.0.0.0" || host_ == "::";
  const std::string& host = everywhere && !machine_.empty() ? machine_ : host_;
  return "http://" + link::net::format_host_port({host, port_}) + "/";
}

std::string random_token() {
  std::random_device random;  // on Linux that of the system
  std::string token;
  for (int i = 0; i < 4; ++i) put(token, "{:08x}", static_cast<std::uint32_t>(random()));
  return token;
}

bool is_token(std::string_view text) {
  return text.size() >= kShortestToken && text.size() <= std::size_t{kLongestToken} &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
         });
}

}  // namespace symplant::panel
