// Who listens on a port of this machine.
#include "symplant/link/modbus/port_owner.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace symplant::link::modbus {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListening = "0A";  ///< the state as /proc/net/tcp writes it

/// `socket:[INODE]` of every socket that listens on the port.
std::vector<std::string> listeners(const char* table, std::uint16_t port) {
  std::ifstream stream(table);
  std::vector<std::string> found;
  std::string line;
  std::getline(stream, line);  // the head
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string row, local, remote, state, queues, timer, retransmits, user, timeout, inode;
    fields >> row >> local >> remote >> state >> queues >> timer >> retransmits >> user >> timeout >> inode;
    const std::size_t colon = local.find(':');
    if (state != kListening || colon == local.npos) continue;
    std::uint16_t number = 0;
    std::from_chars(local.data() + colon + 1, local.data() + local.size(), number, 16);
    if (number == port) found.push_back("socket:[" + inode + "]");
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

std::optional<PortOwner> owner_of_port(std::uint16_t port) {
  std::vector<std::string> sockets = listeners("/proc/net/tcp", port);
  for (std::string& socket : listeners("/proc/net/tcp6", port)) sockets.push_back(std::move(socket));
  if (sockets.empty()) return std::nullopt;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    pid_t process = 0;
    const auto [stop, fault] = std::from_chars(name.data(), name.data() + name.size(), process);
    if (fault != std::errc() || stop != name.data() + name.size()) continue;
    if (has_one_of(entry->path(), sockets)) return PortOwner{program_of(entry->path()), process};
  }
  return std::nullopt;
}

}  // namespace symplant::link::modbus
