// The interface of a link to the cycle and its host, independent of its protocol.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/link_command.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// Why a link cannot be created or started; `kind` decides the exit code (2 or 3).
struct LinkError {
  enum class Kind { usage, environment } kind;
  std::string message;
};

struct LinkStatus {
  std::uint64_t requests = 0;  ///< answered requests, exceptions included
  std::uint64_t exceptions = 0;
  std::uint64_t writes_to_gaps = 0;  ///< written addresses that no symbol has, outside of the map's transfer range
  std::uint32_t connections = 0;     ///< open now
  std::uint64_t crowded_out = 0;     ///< clients closed because there was no room for all
  std::uint32_t losses = 0;          ///< how often the link was lost
  bool end_unread = false;           ///< leave() was called, and the PLC does not have it yet
  bool is_client = false;            ///< the link goes to the PLC, which is a server
  bool reached = false;              ///< a client link: it has had a connection since the start
  bool has_nodes = false;  ///< a server link whose clients name symbols by node ids, in any number of sessions
  bool armed = true;       ///< a client link: it may write events
};

/// What a link finds about its PLC.
struct LinkFinding {
  tables::FindingKind kind = {};
  std::uint32_t symbol = tables::kNone;  ///< tables::kNone: the finding is of the link
  std::uint64_t value = 0;               ///< as trace::Record::value
};

/// A running link to a PLC. The cycle uses it as an Exchange; any thread may call the other members.
class Link : public exec::Exchange {
 public:
  /// The bound address, as a URL with the real port.
  virtual std::string url() const = 0;

  virtual LinkStatus status() const noexcept = 0;

  /// While it is cut, the link exchanges nothing, as if its cable were pulled out; afterwards it works again by itself.
  /// For the cycle's thread: wait-free.
  virtual void cut(bool) noexcept {}

  /// The BOOL events, as rows in PlantTables::symbols, that the PLC reads by requests to the link. Such a link itself
  /// finds the events that came and went between two reads.
  virtual std::vector<std::uint32_t> events_on_request() const { return {}; }

  /// The next of the findings of this link; nothing if there is no new one. For the cycle's thread: wait-free.
  virtual std::optional<LinkFinding> take_finding() noexcept { return std::nullopt; }

  /// Whether clients of the link may command the run.
  virtual bool has_commands() const { return false; }
  /// The next command of a client; nothing if there is no new one. `frozen`: whether the plant is frozen by something
  /// other than commands. For the cycle's thread: wait-free.
  virtual std::optional<LinkCommand> take_command(bool /*frozen*/) noexcept { return std::nullopt; }

  /// What the link has to report to the user since the last call, in words. Not for the cycle's thread.
  virtual std::vector<std::string> take_messages() { return {}; }
};

inline constexpr std::uint32_t kAllControllers = 0xFFFF'FFFF;

/// A link and the controller whose symbols it carries.
struct LinkChoice {
  std::string url;
  std::uint32_t controller = 0;  ///< in PlantTables::controller_names; kAllControllers: only with `loop:`
  LinkSettings settings = {};
};

/// A link, or the error.
using LinkResult = std::variant<std::unique_ptr<Link>, LinkError>;

/// Why the URL is invalid on any machine; empty if it is valid. Opens nothing and resolves no name. O(1).
std::string url_fault(std::string_view url);

/// Creates and starts the link of a URL, such as `loop:` or `modbus-tcp-server://HOST:PORT` (port 0: any free port).
/// Tables must outlive it. If `plant` is given, the link has its events before it answers the first request.
LinkResult open_link(const LinkChoice& link, const tables::PlantTables& tables, const plant::Plant* plant = nullptr);

}  // namespace symplant::link
