// What the cycle and its host ask of a link, whatever its protocol.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// Why a link could not be made or started; `kind` decides the exit code (2 or 3).
struct LinkError {
  enum class Kind { usage, environment } kind;
  std::string message;
};

struct LinkStatus {
  std::uint64_t requests = 0;  ///< answered, exceptions included
  std::uint64_t exceptions = 0;
  std::uint64_t writes_to_gaps = 0;  ///< places written that no symbol stands on
  std::uint32_t connections = 0;     ///< open now
  std::uint64_t crowded_out = 0;     ///< clients closed, since there was no room for all
  std::uint32_t losses = 0;          ///< how often its PLC fell silent
  bool end_unread = false;           ///< the link was left, and a PLC that reads the status block has not seen it yet
};

/// A running link to a PLC. The cycle uses it as an Exchange; the rest may be asked by any thread.
class Link : public exec::Exchange {
 public:
  /// What it is bound to, as a URL with the real port.
  virtual std::string url() const = 0;

  virtual LinkStatus status() const noexcept = 0;
};

inline constexpr std::uint32_t kAllControllers = 0xFFFF'FFFF;

/// A link, and whose symbols it carries.
struct LinkChoice {
  std::string url;
  std::uint32_t controller = 0;  ///< in PlantTables::controller_names; kAllControllers: of `loop:` alone
  LinkSettings settings = {};
};

/// A link, or why there is none.
using LinkResult = std::variant<std::unique_ptr<Link>, LinkError>;

/// Why no link can have this URL, on whatever machine; empty where one can. Opens nothing and asks for no name. O(1).
std::string url_fault(std::string_view url);

/// Makes and starts the link that a URL names: `loop:`, `modbus-tcp-server://HOST:PORT` (port 0: any that is free).
/// Tables must outlive it. With `plant` given the link has its events before it answers anybody.
LinkResult open_link(const LinkChoice& link, const tables::PlantTables& tables, const plant::Plant* plant = nullptr);

}  // namespace symplant::link
