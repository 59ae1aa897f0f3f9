// The settings of an SLMP link: the parameters of its URL.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/net/client_socket.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/slmp/framing.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::slmp {

/// How events at X reach the PLC if no `map` moves them.
enum class EventAccess : std::uint8_t {
  unset,   ///< not chosen: a plant with such events cannot be linked
  direct,  ///< written to X, for X without an input module
  dx,      ///< written to DX, the direct access to X
};

/// Moves devices: `map=X0-X7F:M1000`.
struct Move {
  Device first;
  std::uint32_t last = 0;
  Device to;
};

/// Gives a symbol another device: `map=LINE_S1_CYL_I_OUT:M5`.
struct SymbolMove {
  std::string symbol;
  Device to;
};

struct Settings {
  net::HostPort address;
  net::Transport transport = net::Transport::tcp;
  Framing framing;
  /// For a connection, and for one answer; by default less than LinkSettings::loss_after.
  tables::Time timeout = 800 * tables::kMillisecond;
  client::ClientTimes times = {.read_back = tables::kSecond};
  EventAccess events = EventAccess::unset;
  std::vector<Move> moves;
  std::vector<SymbolMove> symbol_moves;
};

/// Reads `//HOST:PORT?family=q&...`, the URL after `slmp:`. Errors are of kind usage. O(length).
std::variant<Settings, LinkError> read_settings(std::string_view rest);

}  // namespace symplant::link::slmp
