// The process that listens on a port, as /proc of Linux shows it.
#include "symplant/link/net/port_owner.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace symplant::link::net {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListening = "0A";  ///< the state as /proc/net/tcp writes it

constexpr std::string_view kAll4 = "0000000000000000FFFF000000000000";
constexpr std::string_view kAll6 = "00000000000000000000000000000000";
constexpr std::string_view kMapped = kAll4.substr(0, 24);  ///< prefix of an IPv4 address mapped to IPv6

/// An address and port to listen on, as in /proc/net/tcp6; an IPv4 address is mapped.
struct Endpoint {
  std::string address;
  std::uint16_t port = 0;
};

Endpoint endpoint_of(const sockaddr& address) {
  std::array<std::uint32_t, 4> words{};
  Endpoint endpoint;
  const bool six = address.sa_family == AF_INET6;
  if (six) {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(address);
    std::memcpy(words.data(), &v6.sin6_addr, sizeof words);
    endpoint.port = ntohs(v6.sin6_port);
  } else {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(address);
    words = {0, 0, htonl(0xFFFF), v4.sin_addr.s_addr};
    endpoint.port = ntohs(v4.sin_port);
  }
  for (const std::uint32_t word : words) {
    std::array<char, 9> hex{};
    std::snprintf(hex.data(), hex.size(), "%08X",
                  static_cast<unsigned>(word));  // in the machine's byte order, as in /proc
    endpoint.address += hex.data();
  }
  return endpoint;
}

/// Parses the column of a local address, "0100007F:05DE"; port 0 if it is not an address.
Endpoint endpoint_of(std::string_view column) {
  Endpoint endpoint;
  const std::size_t colon = column.find(':');
  if (colon == column.npos) return endpoint;
  std::from_chars(column.data() + colon + 1, column.data() + column.size(), endpoint.port, 16);
  endpoint.address = column.substr(0, colon);
  if (endpoint.address.size() == 8) endpoint.address.insert(0, kMapped);
  return endpoint;
}

bool covers(std::string_view all, std::string_view address) {
  return all == kAll6 || (all == kAll4 && address.substr(0, kMapped.size()) == kMapped);
}

/// Whether two sockets cannot listen on both.
bool collide(const Endpoint& a, const Endpoint& b) {
  return a.port == b.port && (a.address == b.address || covers(a.address, b.address) || covers(b.address, a.address));
}

/// `socket:[INODE]` of every socket that listens and collides with `wanted`.
std::vector<std::string> listeners(const char* table, const Endpoint& wanted) {
  std::ifstream stream(table);
  std::vector<std::string> found;
  std::string line;
  std::getline(stream, line);  // the head
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string row, local, remote, state, queues, timer, retransmits, user, timeout, inode;
    fields >> row >> local >> remote >> state >> queues >> timer >> retransmits >> user >> timeout >> inode;
    if (state == kListening && collide(endpoint_of(local), wanted)) found.push_back("socket:[" + inode + "]");
  }
  return found;
}

bool has_one_of(const fs::path& process, const std::vector<std::string>& sockets) {
  std::error_code error;
  for (fs::directory_iterator fd(process / "fd", error), end; !error && fd != end; fd.increment(error)) {
    std::array<char, 64> target{};
    const ssize_t size = ::readlink(fd->path().c_str(), target.data(), target.size());
    if (size <= 0) continue;
    const std::string_view name(target.data(), static_cast<std::size_t>(size));
    if (std::find(sockets.begin(), sockets.end(), name) != sockets.end()) return true;
  }
  return false;
}

std::string program_of(const fs::path& process) {
  std::ifstream stream(process / "comm");
  std::string name;
  std::getline(stream, name);
  for (char& c : name) {
    if (c < ' ' || c > '~' || c == '`') c = '?';
  }
  return name;
}

}  // namespace

std::optional<PortOwner> owner_of_port(const sockaddr& address) {
  const Endpoint wanted = endpoint_of(address);
  std::vector<std::string> sockets = listeners("/proc/net/tcp", wanted);
  for (std::string& socket : listeners("/proc/net/tcp6", wanted)) sockets.push_back(std::move(socket));
  if (sockets.empty()) return std::nullopt;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    pid_t process = 0;
    const auto [stop, fault] = std::from_chars(name.data(), name.data() + name.size(), process);
    if (fault != std::errc() || stop != name.data() + name.size()) continue;
    if (has_one_of(entry->path(), sockets)) {
      return PortOwner{program_of(entry->path()), static_cast<unsigned long>(process), process == ::getpid()};
    }
  }
  return std::nullopt;
}

const char* how_to_find_owner() { return "sudo ss -ltnp"; }

}  // namespace symplant::link::net
