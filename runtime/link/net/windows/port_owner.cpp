// The process that listens on a port, as Windows lists its connections.
#include "symplant/link/net/port_owner.hpp"

#include <iphlpapi.h>

#include <array>
#include <filesystem>
#include <vector>

namespace symplant::link::net {
namespace {

std::string program_of(DWORD process) {
  HANDLE const handle = OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, process);
  if (handle == nullptr) return "another program";
  std::array<wchar_t, MAX_PATH + 1> path{};
  DWORD size = static_cast<DWORD>(path.size());
  const bool known = QueryFullProcessImageNameW(handle, 0, path.data(), &size) != 0;
  CloseHandle(handle);
  return known ? std::filesystem::path(path.data()).filename().string() : "another program";
}

bool collides(DWORD listens, DWORD wanted) { return listens == wanted || listens == 0 || wanted == 0; }

}  // namespace

std::optional<PortOwner> owner_of_port(const sockaddr& address) {
  if (address.sa_family != AF_INET) return std::nullopt;
  const auto& wanted = reinterpret_cast<const sockaddr_in&>(address);
  DWORD size = 0;
  GetExtendedTcpTable(nullptr, &size, FALSE, AF_INET, TCP_TABLE_OWNER_PID_LISTENER, 0);
  std::vector<DWORD> room(size / sizeof(DWORD) + 256);
  size = static_cast<DWORD>(room.size() * sizeof(DWORD));
  if (GetExtendedTcpTable(room.data(), &size, FALSE, AF_INET, TCP_TABLE_OWNER_PID_LISTENER, 0) != NO_ERROR)
    return std::nullopt;
  const auto& table = *reinterpret_cast<const MIB_TCPTABLE_OWNER_PID*>(room.data());
  for (DWORD i = 0; i < table.dwNumEntries; ++i) {
    const MIB_TCPROW_OWNER_PID& row = table.table[i];
    if (static_cast<u_short>(row.dwLocalPort) != wanted.sin_port) continue;
    if (!collides(row.dwLocalAddr, wanted.sin_addr.s_addr)) continue;
    if (row.dwOwningPid == 0) return std::nullopt;
    return PortOwner{program_of(row.dwOwningPid), row.dwOwningPid, row.dwOwningPid == GetCurrentProcessId()};
  }
  return std::nullopt;
}

const char* how_to_find_owner() { return "netstat -ano"; }

}  // namespace symplant::link::net
