// Finds the owner of a port.
#include "symplant/link/net/port_owner.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "symplant/link/net/listener.hpp"

using namespace symplant::link::net;

namespace {

std::optional<PortOwner> owner_at(const char* host, std::uint16_t port) {
  sockaddr_in v4{};
  v4.sin_family = AF_INET;
  v4.sin_port = htons(port);
  if (::inet_pton(AF_INET, host, &v4.sin_addr) == 1) return owner_of_port(reinterpret_cast<const sockaddr&>(v4));
  sockaddr_in6 v6{};
  v6.sin6_family = AF_INET6;
  v6.sin6_port = htons(port);
  ::inet_pton(AF_INET6, host, &v6.sin6_addr);
  return owner_of_port(reinterpret_cast<const sockaddr&>(v6));
}

/// Other programs may have the port on other addresses.
bool is_ours(const char* host, const Listener& listener) {
  const auto owner = owner_at(host, listener.bound.port);
  return owner && owner->is_this;
}

}  // namespace

TEST_CASE("The owner of a port is reported by program and process, for IPv4 and IPv6") {
  const Listener four = std::get<Listener>(listen_on({"127.0.0.1", 0}));
  const auto owner = owner_at("127.0.0.1", four.bound.port);
  REQUIRE(owner);
  CHECK(owner->is_this);
  CHECK(owner->program.substr(0, 5) == "test_");
  auto six = listen_on({"::1", 0});
  if (auto* listener = std::get_if<Listener>(&six)) CHECK(is_ours("::1", *listener));
  CHECK_FALSE(owner_at("127.0.0.1", 0));
}

TEST_CASE("A listener on another address does not own the port, a listener on all addresses does") {
  const Listener one = std::get<Listener>(listen_on({"127.0.0.2", 0}));
  CHECK(is_ours("127.0.0.2", one));
  CHECK_FALSE(is_ours("127.0.0.1", one));
  CHECK_FALSE(is_ours("::1", one));
  CHECK(is_ours("0.0.0.0", one));
  CHECK(is_ours("::", one));
  const Listener all = std::get<Listener>(listen_on({"0.0.0.0", 0}));
  CHECK(is_ours("127.0.0.1", all));
  CHECK_FALSE(is_ours("::1", all));
}
